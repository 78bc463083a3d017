// How far colours that lie side by side are apart for people who lack one kind of cone: seen as
// Machado, Oliveira and Fernandes (IEEE TVCG 15, 2009, table 1, severity 1.0) simulate it on linear
// sRGB, and held against each other in CIELAB (CIE 1976) for a white of D65.

#include "widgets/scene/appearance.h"
#include "widgets/scene/part_look.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace carina;

namespace
{

constexpr double kClear = 14.0; ///< several times what is just noticed, 2.3

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Sight {
    const char* name;
    Matrix seen;
};
const std::array<Sight, 4> kSights{{
    {"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}},
}};
constexpr Matrix kToXyz{
    {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
constexpr Triple kWhite{0.95047, 1.0, 1.08883};

Triple times(const Matrix& m, const Triple& v)
{
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            product[i] += m[i][j] * v[j];
    return product;
}

double linear(double coded)
{
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

Triple inLab(const QColor& color, const Sight& sight)
{
    Triple light =
        times(sight.seen, {linear(color.redF()), linear(color.greenF()), linear(color.blueF())});
    for (double& channel : light)
        channel = std::clamp(channel, 0.0, 1.0);
    Triple xyz = times(kToXyz, light);
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = xyz[i] / kWhite[i];
        xyz[i] = share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116.0;
    }
    return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

double apart(const QColor& a, const QColor& b, const Sight& sight)
{
    const Triple p = inLab(a, sight);
    const Triple q = inLab(b, sight);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
                     + (p[2] - q[2]) * (p[2] - q[2]));
}

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

QTEST_GUILESS_MAIN(TestColourVision)
#include "tst_colour_vision.moc"
