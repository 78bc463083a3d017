#include "tests/support/test_class.h"
#include "widgets/scene/look/appearance.h"

namespace carina::appearance_test
{

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
    void showsLungsAsLungs_data();
    void showsLungsAsLungs();
    void givesEachRoleAColour();
    void showsTheTubeThroughWhatItGoesInto_data();
    void showsTheTubeThroughWhatItGoesInto();
    void tellsVeinsFromArteriesByName();
    void drawsOpaqueFirstAndSkinLast();
    void listsEachRoleUnderARegion_data();
    void listsEachRoleUnderARegion();
};

void TestAppearance::listsEachRoleUnderARegion_data()
{
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<BodyRegion>("region");
    QTest::newRow("trachea") << PartRole::Trachea << BodyRegion::Airway;
    QTest::newRow("bronchial tree") << PartRole::BronchialTree << BodyRegion::Airway;
    QTest::newRow("tongue") << PartRole::Tongue << BodyRegion::Airway;
    QTest::newRow("left lower lobe") << PartRole::LeftLowerLobe << BodyRegion::Lungs;
    QTest::newRow("whole right lung") << PartRole::RightLung << BodyRegion::Lungs;
    QTest::newRow("tooth") << PartRole::Tooth << BodyRegion::Skeleton;
    QTest::newRow("rib") << PartRole::Rib << BodyRegion::Skeleton;
    QTest::newRow("heart") << PartRole::Heart << BodyRegion::Vessels;
    QTest::newRow("vessel") << PartRole::Vessel << BodyRegion::Vessels;
    QTest::newRow("diaphragm") << PartRole::Diaphragm << BodyRegion::Muscles;
    QTest::newRow("muscle") << PartRole::Muscle << BodyRegion::Muscles;
    QTest::newRow("skin") << PartRole::Skin << BodyRegion::Other;
    QTest::newRow("not recognised") << PartRole::Other << BodyRegion::Other;
}

void TestAppearance::listsEachRoleUnderARegion()
{
    QFETCH(PartRole, role);
    QFETCH(BodyRegion, region);
    QCOMPARE(bodyRegionOf(role), region);
}

void TestAppearance::showsLungsAsLungs_data()
{
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<bool>("lung");
    QTest::newRow("right upper lobe") << PartRole::RightUpperLobe << true;
    QTest::newRow("right middle lobe") << PartRole::RightMiddleLobe << true;
    QTest::newRow("right lower lobe") << PartRole::RightLowerLobe << true;
    QTest::newRow("right lung") << PartRole::RightLung << true;
    QTest::newRow("left upper lobe") << PartRole::LeftUpperLobe << true;
    QTest::newRow("left lower lobe") << PartRole::LeftLowerLobe << true;
    QTest::newRow("left lung") << PartRole::LeftLung << true;
    QTest::newRow("right main bronchus") << PartRole::RightMainBronchus << false;
    QTest::newRow("rib") << PartRole::Rib << false;
}

void TestAppearance::showsLungsAsLungs()
{
    QFETCH(PartRole, role);
    QFETCH(bool, lung);
    QCOMPARE(of(role).group == MaterialGroup::Lung, lung);
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
          PartRole::Larynx, PartRole::Hyoid, PartRole::Pharynx, PartRole::Mucosa,
          PartRole::LaryngealMucosa, PartRole::RightLung, PartRole::LeftLung, PartRole::Rib,
          PartRole::Heart, PartRole::Vessel, PartRole::Muscle, PartRole::Diaphragm, PartRole::Skin})
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
    QCOMPARE(layerOf(MaterialGroup::Fluid), 0);
    QCOMPARE(layerOf(MaterialGroup::Airway), 1);
    QCOMPARE(layerOf(MaterialGroup::Lung), 2);
    QCOMPARE(layerOf(MaterialGroup::Veil), 3);
    QCOMPARE(layerOf(MaterialGroup::Skin), 4);
    QCOMPARE(layerOf(MaterialGroup::Ghost), kLayers - 1);
}

CARINA_TEST(TestAppearance)

} // namespace carina::appearance_test

#include "tst_appearance.moc"
