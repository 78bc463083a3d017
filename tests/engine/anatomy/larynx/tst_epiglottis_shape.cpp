#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace carina::epiglottis_shape_test
{
namespace
{

constexpr double kStep = 0.02;   ///< millimetres of LarynxFrame
constexpr double kMiddle = 19.5; ///< half way up

BodyPlan planOf(const QString& words)
{
    return bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                      Posture::Laryngoscopy);
}

/// How much of the leaf lies behind each other at a place seen from the front.
double thicknessAt(const Epiglottis& leaf, double x, double z)
{
    double thick = 0.0;
    for (double y = -24.0; y < 16.0; y += kStep)
        thick += leaf.distance({x, y, z}) < 0.0 ? kStep : 0.0;
    return thick;
}

/// Half its width at a height, seen from the front.
double halfWidthAt(const Epiglottis& leaf, double z)
{
    constexpr double kAcross = 0.05;
    constexpr double kThrough = 0.2; // its rim is thicker
    const double middle = leaf.middleAt(z);
    for (double x = 13.0; x > 0.0; x -= kAcross)
        for (double y = middle - 2.0; y < middle + 12.0; y += kThrough)
            if (leaf.distance({x, y, z}) < 0.0)
                return x;
    return 0.0;
}

} // namespace

class TestEpiglottisShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsThickAsPublished_data();
    void isAsThickAsPublished();
    void thinsOutTowardsItsRim();
    void hasARoundRim_data();
    void hasARoundRim();
};

void TestEpiglottisShape::isAsThickAsPublished_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("mean_mm");
    QTest::addColumn<double>("deviation_mm");
    // Of grown people of both sexes (Vadgaonkar 2024); of women, by ultrasound (Paik 2006).
    QTest::newRow("man") << "adult" << 2.6 << 0.3;
    QTest::newRow("woman") << "30 years, 162 cm, woman" << 2.21 << 0.18;
}

void TestEpiglottisShape::isAsThickAsPublished()
{
    QFETCH(QString, words);
    QFETCH(double, mean_mm);
    QFETCH(double, deviation_mm);
    const BodyPlan plan = planOf(words);
    const double unit_mm = 1e3 * LarynxFrame{plan.dimensions}.unit();
    const double thick = unit_mm * thicknessAt(Epiglottis{plan}, 0.0, kMiddle);
    QVERIFY2(std::abs(thick - mean_mm) < deviation_mm, qPrintable(QString::number(thick)));
}

/// Upwards from the middle in the midline, and to the sides at the widest place, where the leaf is
/// bent by less than 30 degrees.
void TestEpiglottisShape::thinsOutTowardsItsRim()
{
    const Epiglottis leaf{Posture::Laryngoscopy, 0.0};
    const auto falls = [](const std::vector<double>& thick) {
        constexpr double kTolerance = 0.05; // of a bent leaf, cut along y
        return std::ranges::is_sorted(thick, [](double a, double b) { return a > b + kTolerance; })
               && thick.back() < 0.85 * thick.front();
    };
    std::vector<double> upwards;
    for (double z = kMiddle; z < 33.8; z += 1.0)
        upwards.push_back(thicknessAt(leaf, 0.0, z));
    QVERIFY(falls(upwards));
    std::vector<double> sidewards;
    for (double x = 0.0; x < 10.8; x += 1.0)
        sidewards.push_back(thicknessAt(leaf, x, 27.0));
    QVERIFY(falls(sidewards));
}

void TestEpiglottisShape::hasARoundRim_data()
{
    QTest::addColumn<double>("omega");
    QTest::newRow("grown") << 0.0;
    QTest::newRow("newborn") << 1.0;
}

/// Seen from the front, from the widest place up its outline turns by less than 27 degrees in each
/// 2 mm: nowhere with a radius below 4.2 mm.
void TestEpiglottisShape::hasARoundRim()
{
    QFETCH(double, omega);
    const Epiglottis leaf{Posture::Laryngoscopy, omega};
    constexpr double kMostTurn_deg = 27.0;
    constexpr double kPiece = 2.0;
    std::vector<Eigen::Vector2d> outline{{halfWidthAt(leaf, 24.0), 24.0}};
    for (double z = 24.0; z < 34.0; z += 0.1) {
        const Eigen::Vector2d at{halfWidthAt(leaf, z), z};
        if ((at - outline.back()).norm() >= kPiece)
            outline.push_back(at);
    }
    QVERIFY(outline.size() > 5);
    for (std::size_t i = 2; i < outline.size(); ++i) {
        const Eigen::Vector2d a = outline[i - 1] - outline[i - 2];
        const Eigen::Vector2d b = outline[i] - outline[i - 1];
        const double turn =
            std::acos(std::min(a.dot(b) / (a.norm() * b.norm()), 1.0)) * 180.0 / std::numbers::pi;
        QVERIFY2(turn < kMostTurn_deg, qPrintable(QString::number(turn)));
    }
}

CARINA_TEST(TestEpiglottisShape)

} // namespace carina::epiglottis_shape_test

#include "tst_epiglottis_shape.moc"
