#include "engine/anatomy/larynx/laryngeal_cavity.h"
#include "engine/anatomy/larynx/laryngeal_mucosa.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace carina::laryngeal_mucosa_test
{
namespace
{

/// The vocal folds of a patient, and what is beside them, before they are meshed, in the
/// millimetres of LarynxFrame.
class Cords
{
public:
    explicit Cords(const QString& words)
        : m_plan(bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                            Posture::Laryngoscopy)),
          m_frame(m_plan.dimensions),
          m_left(fold("Left vocal fold")),
          m_right(fold("Right vocal fold")),
          m_mucosa(fold("Laryngeal mucosa")),
          m_corniculate(fold("Left corniculate tubercle"))
    {
    }

    [[nodiscard]] double left(const Vec3& p) const { return m_left(m_frame.inAnatomy(p)); }
    [[nodiscard]] double right(const Vec3& p) const { return m_right(m_frame.inAnatomy(p)); }
    [[nodiscard]] double white(const Vec3& p) const { return std::min(left(p), right(p)); }
    [[nodiscard]] double mucosa(const Vec3& p) const { return m_mucosa(m_frame.inAnatomy(p)); }
    [[nodiscard]] double corniculate(const Vec3& p) const
    {
        return m_corniculate(m_frame.inAnatomy(p));
    }
    [[nodiscard]] double unit_mm() const { return 1e3 * m_frame.unit(); }

private:
    [[nodiscard]] Implicit fold(const std::string& name) const
    {
        const auto parts = laryngealMucosa(m_plan, m_frame, Epiglottis{m_plan});
        return std::ranges::find(parts, name, &PartPlan::name)->shape.distance;
    }

    BodyPlan m_plan;
    LarynxFrame m_frame;
    Implicit m_left;
    Implicit m_right;
    Implicit m_mucosa;
    Implicit m_corniculate;
};

/// The first white at an x on the way forward from within the glottis, level with the cords.
Vec2 edgeInFront(const Cords& cords, double x)
{
    double y = -8.0;
    while (y > -16.0 && !(cords.white({x, y, 0.0}) < 0.0))
        y -= 0.01;
    return {x, y};
}

/// The direction in which a function grows.
template <class Function> Vec3 steepest(const Function& function, const Vec3& p)
{
    constexpr double kStep = 0.02;
    Vec3 slope;
    for (int k = 0; k < 3; ++k)
        slope[k] = function(p + kStep * Vec3::Unit(k)) - function(p - kStep * Vec3::Unit(k));
    return slope.normalized();
}

/// Where the white of the left cord meets the floor of the ventricle, at a y.
Vec3 borderOnFloor(const Cords& cords, double y)
{
    Vec3 p{0.0, y, 0.0};
    for (double x = 8.0; x > 0.0; x -= 0.02) {
        double z = 3.0; // below the vestibular folds
        while (z > -3.0 && cords.mucosa({x, y, z}) > 0.0)
            z -= 0.02;
        p = {x, y, z};
        if (cords.left(p) < 0.0)
            break;
    }
    return p;
}

/// Between two directions in the plane, degrees.
double turnBetween(const Vec2& a, const Vec2& b)
{
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    return std::abs(turn) * 180.0 / std::numbers::pi;
}

} // namespace

/// The folds of the larynx as functions, in their own millimetres.
class TestLaryngealMucosa : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cordsMeetInARoundCommissure_data() { people(); }
    void cordsMeetInARoundCommissure();
    void cordsAreBandsOfOneWidth_data() { people(); }
    void cordsAreBandsOfOneWidth();
    void cordsAreMembranousForThreeFifths();
    void cordsAreAsLongAsPublished_data();
    void cordsAreAsLongAsPublished();
    void cordsDipSteeplyIntoTheFloor_data() { people(); }
    void cordsDipSteeplyIntoTheFloor();
    void corniculateTuberclesAreOfOneSide();

private:
    static void people()
    {
        QTest::addColumn<QString>("words");
        for (const char* words : {"adult", "45 years, 165 cm, woman", "newborn, 50 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

/// Their edges go over into each other: in steps of a voxel the edge turns by less than 60 degrees.
/// The white of both sides covers the midline, so that no gap divides it.
void TestLaryngealMucosa::cordsMeetInARoundCommissure()
{
    QFETCH(QString, words);
    const Cords cords{words};
    constexpr double kVoxel = 0.65;
    constexpr double kMostTurn_deg = 60.0;
    std::vector<Vec2> edge{edgeInFront(cords, -1.2)};
    for (double x = -1.2; x <= 1.2; x += 0.02)
        if (const Vec2 at = edgeInFront(cords, x); (at - edge.back()).norm() >= 0.75 * kVoxel)
            edge.push_back(at);
    QVERIFY(edge.size() > 5);
    for (std::size_t i = 2; i < edge.size(); ++i) {
        const double turn = turnBetween(edge[i - 1] - edge[i - 2], edge[i] - edge[i - 1]);
        QVERIFY2(turn < kMostTurn_deg, qPrintable(QString::number(turn)));
    }
    const double front = edgeInFront(cords, 0.0).y();
    for (double y = front - 0.3; y > front - 1.5; y -= 0.2) {
        QVERIFY2(cords.left({0.0, y, 0.0}) < 0.0, qPrintable(QString::number(y)));
        QVERIFY2(cords.right({0.0, y, 0.0}) < 0.0, qPrintable(QString::number(y)));
    }
}

/// As far as the vocal process; behind it they run out.
void TestLaryngealMucosa::cordsAreBandsOfOneWidth()
{
    QFETCH(QString, words);
    const Cords cords{words};
    constexpr double kTolerance = 0.1; // of the width
    std::vector<double> widths;
    for (double y = -11.0; y <= 1.0; y += 1.0) {
        double white = 0.0;
        for (double x = 0.0; x < 12.0; x += 0.02)
            white += cords.left({x, y, 0.0}) < 0.0 ? 0.02 : 0.0;
        widths.push_back(white);
    }
    const auto [least, most] = std::ranges::minmax(widths);
    QVERIFY2(least > 2.0 && most < 3.5, qPrintable(QString::number(least)));
    QVERIFY2(most < (1.0 + kTolerance) * least, qPrintable(QString::number(most)));
}

/// 63 % in men and 58 in women (Friedrich 1993).
void TestLaryngealMucosa::cordsAreMembranousForThreeFifths()
{
    const double front = edgeInFront(Cords{QStringLiteral("adult")}, 0.0).y();
    const LaryngealCavity cavity{Vec2{8.5, 6.5}};
    double back = 5.0;
    while (cavity.distance({0.0, back, 0.0}) < 0.0)
        back += 0.01;
    const double share = (kVocalProcess_mm - front) / (back - front);
    QVERIFY2(share > 0.55 && share < 0.65, qPrintable(QString::number(share)));
}

void TestLaryngealMucosa::cordsAreAsLongAsPublished_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("mean_mm");
    QTest::addColumn<double>("deviation_mm");
    // Whole folds at microlaryngeal surgery (Jibi Inkoka Keibu 125(6)).
    QTest::newRow("man") << "adult" << 14.8 << 3.0;
    QTest::newRow("woman") << "30 years, 162 cm, woman" << 12.7 << 2.3;
}

void TestLaryngealMucosa::cordsAreAsLongAsPublished()
{
    QFETCH(QString, words);
    QFETCH(double, mean_mm);
    QFETCH(double, deviation_mm);
    const Cords cords{words};
    const auto isWhiteAt = [&](double y) {
        for (double x = -1.0; x < 8.0; x += 0.05)
            if (cords.left({x, y, 0.0}) < 0.0)
                return true;
        return false;
    };
    double front = -18.0;
    while (front < 0.0 && !isWhiteAt(front))
        front += 0.05;
    double back = 12.0;
    while (back > front && !isWhiteAt(back))
        back -= 0.05;
    const double length = cords.unit_mm() * (back - front);
    QVERIFY2(std::abs(length - mean_mm) < deviation_mm, qPrintable(QString::number(length)));
}

/// Their surface leaves the floor of the ventricle at more than half a right angle, so that an
/// error of either surface moves the border between white and pink by no more than itself.
void TestLaryngealMucosa::cordsDipSteeplyIntoTheFloor()
{
    QFETCH(QString, words);
    const Cords cords{words};
    for (double y = -9.0; y <= -3.0; y += 1.0) {
        const Vec3 p = borderOnFloor(cords, y);
        const Vec3 up = steepest([&](const Vec3& at) { return cords.mucosa(at); }, p);
        const Vec3 out = steepest([&](const Vec3& at) { return cords.left(at); }, p);
        QVERIFY2(p.x() > 2.0, qPrintable(QString::number(p.x())));
        QVERIFY2(up.dot(out) < std::sqrt(0.5), qPrintable(QString::number(up.dot(out))));
    }
}

/// Nothing of the left one lies in the right half.
void TestLaryngealMucosa::corniculateTuberclesAreOfOneSide()
{
    const Cords cords{QStringLiteral("adult")};
    double nearest = 1e9;
    double opposite = 1e9;
    for (double x = 0.5; x < 8.0; x += 0.5)
        for (double y = 7.0; y < 15.0; y += 0.5)
            for (double z = 4.0; z < 13.0; z += 0.5) {
                nearest = std::min(nearest, cords.corniculate({x, y, z}));
                opposite = std::min(opposite, cords.corniculate({-x, y, z}));
            }
    QVERIFY(nearest < 0.0);
    QVERIFY(opposite > 0.0);
}

CARINA_TEST(TestLaryngealMucosa)

} // namespace carina::laryngeal_mucosa_test

#include "tst_laryngeal_mucosa.moc"
