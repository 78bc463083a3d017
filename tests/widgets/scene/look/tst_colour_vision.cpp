// How far colours that lie side by side are apart for people who lack one kind of cone.

#include "tests/support/test_class.h"
#include "tests/widgets/colour_vision.h"
#include "widgets/scene/look/appearance.h"
#include "widgets/scene/look/part_look.h"

namespace carina::colour_vision_test
{

using namespace carina::test;

namespace
{

constexpr double kClear = 14.0; ///< several times what is just noticed, 2.3

QColor colorOf(PartRole role, const char* name = "")
{
    AnatomyPart part;
    part.role = role;
    part.name = name;
    return appearanceOf(part).color;
}

} // namespace

class TestColourVision : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresAsPublished();
    void separatesWhatLiesSideBySide_data();
    void separatesWhatLiesSideBySide();
    void separatesWhatIsHighlightedFromAllElse();
};

void TestColourVision::measuresAsPublished()
{
    // White is 100 light and grey to everybody; sRGB's red has L 53.2, a 80.1, b 67.2.
    for (const Sight& sight : kSights)
        QVERIFY(std::abs(inLab(Qt::white, sight)[0] - 100.0) < 0.1);
    const Triple red = inLab(QColor(255, 0, 0), kSights[0]);
    QVERIFY(std::abs(red[0] - 53.2) < 0.1);
    QVERIFY(std::abs(red[1] - 80.1) < 0.1);
    QVERIFY(std::abs(red[2] - 67.2) < 0.1);
}

void TestColourVision::separatesWhatLiesSideBySide_data()
{
    QTest::addColumn<QColor>("one");
    QTest::addColumn<QColor>("other");
    using enum PartRole;
    const QColor artery = colorOf(Vessel, "Aorta");
    const QColor vein = colorOf(Vessel, "Superior vena cava");
    const auto row = [](const char* name, const QColor& one, const QColor& other) {
        QTest::newRow(name) << one << other;
    };
    const auto roles = [&](PartRole one, PartRole other) {
        row(qPrintable(QStringLiteral("%1, %2").arg(QLatin1String{roleName(one)},
                                                    QLatin1String{roleName(other)})),
            colorOf(one), colorOf(other));
    };
    for (const PartRole lobe : {RightUpperLobe, RightMiddleLobe, RightLowerLobe, LeftUpperLobe,
                                LeftLowerLobe, RightLung}) {
        for (const PartRole beside : {Rib, Diaphragm, Heart, BronchialTree, Trachea, Spine})
            roles(lobe, beside);
        row(qPrintable(QLatin1String{roleName(lobe)} + QStringLiteral(", artery")), colorOf(lobe),
            artery);
        row(qPrintable(QLatin1String{roleName(lobe)} + QStringLiteral(", vein")), colorOf(lobe),
            vein);
    }
    roles(RightUpperLobe, RightMiddleLobe);
    roles(RightUpperLobe, RightLowerLobe);
    roles(RightMiddleLobe, RightLowerLobe);
    roles(LeftUpperLobe, LeftLowerLobe);
    roles(Trachea, Oesophagus);
    roles(Trachea, Heart);
    roles(Larynx, Pharynx);
    roles(Larynx, Epiglottis);
    roles(Larynx, Muscle);
    roles(Epiglottis, Tongue);
    roles(Epiglottis, Pharynx);
    for (const PartRole beside : {Mandible, Tooth, Pharynx, Muscle})
        roles(Tongue, beside);
    for (const PartRole beside : {Spine, Heart, Pharynx})
        roles(Oesophagus, beside);
    for (const PartRole beside : {Rib, Skin, Mandible, Skull})
        roles(Muscle, beside);
    roles(Diaphragm, Heart);
    roles(Diaphragm, Rib);
    roles(Skin, Skull);
    row("artery, vein", artery, vein);
    row("heart, artery", colorOf(Heart), artery);
    row("heart, vein", colorOf(Heart), vein);
    row("muscle, artery", colorOf(Muscle), artery);
    row("muscle, vein", colorOf(Muscle), vein);
    row("oesophagus, artery", colorOf(Oesophagus), artery);
    row("trachea, artery", colorOf(Trachea), artery);
    row("trachea, vein", colorOf(Trachea), vein);
}

void TestColourVision::separatesWhatLiesSideBySide()
{
    QFETCH(QColor, one);
    QFETCH(QColor, other);
    for (const Sight& sight : kSights)
        QVERIFY2(apart(one, other, sight) >= kClear,
                 qPrintable(QStringLiteral("%1: %2")
                                .arg(QLatin1String{sight.name})
                                .arg(apart(one, other, sight))));
}

void TestColourVision::separatesWhatIsHighlightedFromAllElse()
{
    for (int role = 0; role <= static_cast<int>(PartRole::Other); ++role)
        for (const Sight& sight : kSights)
            QVERIFY2(apart(kHighlight, colorOf(static_cast<PartRole>(role)), sight) >= kClear,
                     roleName(static_cast<PartRole>(role)));
}

CARINA_TEST(TestColourVision)

} // namespace carina::colour_vision_test

#include "tst_colour_vision.moc"
