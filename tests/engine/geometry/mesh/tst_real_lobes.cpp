#include "engine/geometry/mesh/mesh_repair.h"
#include "engine/geometry/mesh/mesh_weld.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "tests/engine/geometry/mesh/plain_obj.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <array>
#include <cmath>
#include <map>

namespace carina::real_lobes_test
{
namespace
{

constexpr Length kTolerance = millimetres(0.01);
constexpr double kVolumeTolerance = 0.003; // share: columns of 1 mm, and what lies over a hole

/// Volume of a surface that may have holes, m^3, as columns along y, 1 mm apart, between the places
/// where they enter and leave it; a column that passes through a hole counts as the one before it.
/// Needs neither closedness nor caps.
double volumeByColumns(const TriangleMesh& mesh)
{
    constexpr double kPitch = 1e-3;
    constexpr double kOffset = 0.000123456; // keeps columns off vertices, given to 0.1 um
    std::map<std::pair<int, int>, std::pair<int, double>> columns; // (x, z) -> (balance, length)
    for (const Triangle& t : mesh.triangles) {
        std::array<Vec3, 3> p;
        for (int k = 0; k < 3; ++k)
            p[k] = mesh.positions[t[k]].cast<double>();
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
        const Vec3 high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        for (int i = int(std::floor(low.x() / kPitch)); i <= int(high.x() / kPitch) + 1; ++i) {
            for (int k = int(std::floor(low.z() / kPitch)); k <= int(high.z() / kPitch) + 1; ++k) {
                const Vec3 q{i * kPitch + kOffset, 0.0, k * kPitch + kOffset};
                bool inside = normal.y() != 0.0;
                for (int c = 0; c < 3; ++c) {
                    const Vec3 side = (p[(c + 1) % 3] - p[c]).cross(q - p[c]);
                    inside = inside && side.y() * normal.y() > 0.0;
                }
                if (!inside)
                    continue;
                auto& [balance, length] = columns[{i, k}];
                const int leaves = normal.y() > 0.0 ? 1 : -1;
                balance += leaves;
                length += leaves * (normal.dot(p[0] - q) / normal.y());
            }
        }
    }
    double volume = 0.0;
    double last = 0.0;
    for (const auto& [place, column] : columns) {
        last = column.first == 0 ? column.second : last;
        volume += last * kPitch * kPitch;
    }
    return volume;
}

} // namespace

class TestRealLobes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closesRealLobes_data()
    {
        QTest::addColumn<int>("edgesAtHoles"); // from SOURCE.txt: "14-60 boundary edges per lobe"
        QTest::newRow("right_upper_lobe") << 60;
        QTest::newRow("right_middle_lobe") << 20;
        QTest::newRow("right_lower_lobe") << 24;
        QTest::newRow("left_upper_lobe") << 34;
        QTest::newRow("left_lower_lobe") << 14;
    }

    void closesRealLobes()
    {
        const auto folder = test::testData("anatomy/lungs");
        if (!folder)
            QSKIP("the real lungs are not here");
        QFETCH(int, edgesAtHoles);
        const TriangleMesh open = welded(
            test::plainObj(*folder / (std::string{QTest::currentDataTag()} + ".obj")), kTolerance);
        QVERIFY(!isClosed(open));
        std::size_t rim = 0;
        for (const BoundaryLoop& loop : boundaryLoops(open))
            rim += loop.size();
        QCOMPARE(rim, static_cast<std::size_t>(edgesAtHoles));
        const TriangleMesh closed = closedSurface(open, kTolerance);
        QVERIFY(isClosed(closed));
        const double expected = volumeByColumns(open);
        const double volume = signedVolume(closed);
        qInfo() << volume * 1e6 << "ml closed," << expected * 1e6 << "ml by columns";
        QVERIFY(std::abs(volume - expected) < kVolumeTolerance * expected);
    }
};

CARINA_TEST(TestRealLobes)

} // namespace carina::real_lobes_test

#include "tst_real_lobes.moc"
