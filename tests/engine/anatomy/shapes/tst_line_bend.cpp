#include "engine/anatomy/shapes/line_bend.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace carina::line_bend_test
{
namespace
{

constexpr double kLength = 0.3;   ///< of the line, metres
constexpr double kRadius = 0.005; ///< of what lies around it, metres
constexpr int kPieces = 64;
constexpr double kSmall_m = 1e-12;
constexpr double kOfPieces_m = 3e-4; ///< by which a line of pieces is off from an arc

/// Along -z.
std::vector<Vec3> straight()
{
    std::vector<Vec3> line;
    for (int i = 0; i <= kPieces; ++i)
        line.emplace_back(0.0, 0.0, -kLength * i / kPieces);
    return line;
}

/// An arc of a quarter circle that begins along -z and bends towards -y.
constexpr double kArc = kLength / (0.5 * std::numbers::pi);
std::vector<Vec3> quarter()
{
    std::vector<Vec3> line;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / kPieces;
        line.emplace_back(0.0, -kArc * (1.0 - std::cos(angle)), -kArc * std::sin(angle));
    }
    return line;
}

} // namespace

class TestLineBend : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesWhatIsNotBent()
    {
        const LineBend bend{quarter(), quarter()};
        for (const Vec3& p :
             {Vec3{0.004, -0.01, -0.05}, Vec3{0.0, -0.1, -0.2}, Vec3{0.0, 0.0, 0.02}})
            QVERIFY((bend.taken(p) - p).norm() < kSmall_m);
    }

    /// A place at the side of a straight line is as far to the side of the arc; one on its inner
    /// face is nearer to the centre of the circle by its distance from the line.
    void takesATubeAlongAnArc()
    {
        const LineBend bend{straight(), quarter()};
        for (int i = 0; i <= 10; ++i) {
            const double along = kLength * i / 10;
            const double angle = along / kArc;
            const auto onArc = [angle](double radius) {
                return Vec3{0.0, -kArc + radius * std::cos(angle), -radius * std::sin(angle)};
            };
            const Vec3 aside = bend.taken({kRadius, 0.0, -along});
            QVERIFY((aside - (onArc(kArc) + kRadius * Vec3::UnitX())).norm() < kOfPieces_m);
            const Vec3 inner = bend.taken({0.0, -kRadius, -along});
            QVERIFY((inner - onArc(kArc - kRadius)).norm() < kOfPieces_m);
        }
    }

    /// A connector in front of the line goes with its beginning.
    void takesWhatLiesBeyondAnEndWithIt()
    {
        const LineBend bend{straight(), quarter()};
        const Vec3 before{0.003, 0.002, 0.02};
        QVERIFY((bend.taken(before) - before).norm() < kOfPieces_m);
        const Vec3 behind = bend.taken({0.0, 0.0, -kLength - 0.01});
        QVERIFY((behind - Vec3{0.0, -kArc - 0.01, -kArc}).norm() < kOfPieces_m);
    }

    void isNotTwistedByABendOutOfItsPlane()
    {
        std::vector<Vec3> helix;
        for (int i = 0; i <= kPieces; ++i) {
            const double angle = 1.5 * i / kPieces;
            helix.emplace_back(0.05 * std::sin(angle), 0.05 * (std::cos(angle) - 1.0),
                               -kLength * i / kPieces);
        }
        const LineBend bend{straight(), helix};
        constexpr double kDistance_m = 1e-9; // of a ring of the tube from its centre
        for (const double angle : {0.0, 1.0, 2.0, 4.0}) {
            const double along = 0.7 * kLength;
            const Vec3 out{kRadius * std::cos(angle), kRadius * std::sin(angle), 0.0};
            const LineBend::Place there = bend.whereBent(along);
            const Vec3 p = bend.taken(Vec3{0.0, 0.0, -along} + out);
            QVERIFY(std::abs((p - there.point).norm() - kRadius) < kDistance_m);
            QVERIFY(std::abs((p - there.point).dot(there.axes.col(0))) < kDistance_m);
        }
    }
};

CARINA_TEST(TestLineBend)

} // namespace carina::line_bend_test

#include "tst_line_bend.moc"
