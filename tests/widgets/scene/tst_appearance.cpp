#include "widgets/scene/appearance.h"

#include <QTest>

using namespace carina;

namespace
{

Appearance of(PartRole role, const char* name = "")
{
    AnatomyPart part;
    part.role = role;
    part.name = name;
    return appearanceOf(part);
}

} // namespace

class TestAppearance : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void breathesLungsWithTheirOwnSide_data();
    void breathesLungsWithTheirOwnSide();
    void givesEachRoleAColour();
    void showsTheTubeThroughWhatItGoesInto_data();
    void showsTheTubeThroughWhatItGoesInto();
    void tellsVeinsFromArteriesByName();
    void drawsOpaqueFirstAndSkinLast();
};

void TestAppearance::breathesLungsWithTheirOwnSide_data()
{
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<AmplitudeChannel>("channel");
    QTest::newRow("right upper lobe") << PartRole::RightUpperLobe << AmplitudeChannel::RightLung;
    QTest::newRow("right middle lobe") << PartRole::RightMiddleLobe << AmplitudeChannel::RightLung;
    QTest::newRow("right lower lobe") << PartRole::RightLowerLobe << AmplitudeChannel::RightLung;
    QTest::newRow("right lung") << PartRole::RightLung << AmplitudeChannel::RightLung;
    QTest::newRow("left upper lobe") << PartRole::LeftUpperLobe << AmplitudeChannel::LeftLung;
    QTest::newRow("left lower lobe") << PartRole::LeftLowerLobe << AmplitudeChannel::LeftLung;
    QTest::newRow("left lung") << PartRole::LeftLung << AmplitudeChannel::LeftLung;
    QTest::newRow("right main bronchus") << PartRole::RightMainBronchus << AmplitudeChannel::None;
    QTest::newRow("rib") << PartRole::Rib << AmplitudeChannel::None;
}

void TestAppearance::breathesLungsWithTheirOwnSide()
{
    QFETCH(PartRole, role);
    QFETCH(AmplitudeChannel, channel);
    QCOMPARE(of(role).channel, channel);
    QCOMPARE(of(role).group == MaterialGroup::Lung, channel != AmplitudeChannel::None);
}

void TestAppearance::givesEachRoleAColour()
{
    for (int role = 0; role <= static_cast<int>(PartRole::Other); ++role)
        QVERIFY2(of(static_cast<PartRole>(role)).color.isValid(),
                 roleName(static_cast<PartRole>(role)));
}

void TestAppearance::showsTheTubeThroughWhatItGoesInto_data()
{
    QTest::addColumn<PartRole>("role");
    for (const PartRole role :
         {PartRole::Trachea, PartRole::RightMainBronchus, PartRole::LeftMainBronchus,
          PartRole::Larynx, PartRole::Pharynx, PartRole::RightLung, PartRole::LeftLung,
          PartRole::Rib, PartRole::Heart, PartRole::Vessel, PartRole::Muscle, PartRole::Diaphragm,
          PartRole::Skin})
        QTest::newRow(roleName(role)) << role;
}

void TestAppearance::showsTheTubeThroughWhatItGoesInto()
{
    QFETCH(PartRole, role);
    QVERIFY(layerOf(of(role).group) > layerOf(MaterialGroup::Tool));
}

void TestAppearance::tellsVeinsFromArteriesByName()
{
    const QColor vein = of(PartRole::Vessel, "Superior vena cava").color;
    const QColor artery = of(PartRole::Vessel, "Pulmonary trunk").color;
    QVERIFY(vein.blue() > vein.red());
    QVERIFY(artery.red() > artery.blue());
    QCOMPARE(of(PartRole::Vessel, "Left Jugular VEIN").color, vein);
    QCOMPARE(of(PartRole::Vessel, "Coronary sinus").color, vein);
}

void TestAppearance::drawsOpaqueFirstAndSkinLast()
{
    QCOMPARE(layerOf(MaterialGroup::Bone), 0);
    QCOMPARE(layerOf(MaterialGroup::SoftTissue), 0);
    QCOMPARE(layerOf(MaterialGroup::Tool), 0);
    QCOMPARE(layerOf(MaterialGroup::Airway), 1);
    QCOMPARE(layerOf(MaterialGroup::Lung), 2);
    QCOMPARE(layerOf(MaterialGroup::Veil), 3);
    QCOMPARE(layerOf(MaterialGroup::Skin), kLayers - 1);
}

QTEST_GUILESS_MAIN(TestAppearance)
#include "tst_appearance.moc"
