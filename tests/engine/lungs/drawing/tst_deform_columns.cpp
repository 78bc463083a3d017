#include "engine/lungs/drawing/chest_pose.h"
#include "engine/lungs/drawing/deform_columns.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/test_class.h"

namespace carina::deform_columns_test
{

namespace
{

constexpr float kTolerance_m = 3e-8F; // one rounding of a coordinate
constexpr float kNormalTolerance = 1e-6F;

ChestField adultChest()
{
    Box lungs_A;
    lungs_A.include(Vec3{-0.13, -0.10, -0.15});
    lungs_A.include(Vec3{0.13, 0.09, 0.10});
    return {lungs_A, {-0.035, 0.01, -0.01}, {0.035, 0.0, 0.005}};
}

/// Some tens of thousands of vertices, so that more than one processor has some.
TriangleMesh lung()
{
    return test::lungLikeMesh({-0.05, 0.0, -0.02}, {0.08, 0.09, 0.12}, 150, 240);
}

Vec3f at(const std::array<std::vector<float>, 3>& columns, std::size_t i)
{
    return {columns[0][i], columns[1][i], columns[2][i]};
}

} // namespace

class TestDeformColumns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movesAsTheReferenceDoes_data();
    void movesAsTheReferenceDoes();
    void fitsItsResultToWhatItIsGiven();
};

void TestDeformColumns::movesAsTheReferenceDoes_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::addColumn<ChestPose>("pose");
    const LungPose deep = 5.0 * kQuietBreath;
    const LungPose shallow = 0.5 * kQuietBreath;
    const LungPose collapsed{.collapse = 0.3};
    QTest::newRow("rest") << ChestRegion::RightUpperLung << ChestPose{};
    QTest::newRow("a lung") << ChestRegion::RightLowerLung << ChestPose{{deep, shallow}};
    QTest::newRow("both lungs") << ChestRegion::Bronchi << ChestPose{{deep, shallow}};
    QTest::newRow("collapsed") << ChestRegion::RightUpperLung << ChestPose{{collapsed, deep}};
    QTest::newRow("shifted") << ChestRegion::Mediastinum << ChestPose{{collapsed, deep}, 0.2};
    QTest::newRow("shifted lung") << ChestRegion::RightUpperLung << ChestPose{{shallow, deep}, 0.2};
}

void TestDeformColumns::movesAsTheReferenceDoes()
{
    QFETCH(ChestRegion, region);
    QFETCH(ChestPose, pose);
    const TriangleMesh rest = lung();
    const ChestMotion motion = motionOf(region, pose, adultChest());
    const TriangleMesh expected = deformed(rest, adultChest(), motion);
    VertexColumns moved;
    deformColumns(columnsOf(rest), adultChest(), motion, moved);
    QCOMPARE(moved.size(), rest.positions.size());
    for (std::size_t i = 0; i < rest.positions.size(); ++i) {
        QVERIFY((at(moved.position, i) - expected.positions[i]).cwiseAbs().maxCoeff()
                < kTolerance_m);
        QVERIFY((at(moved.normal, i) - expected.normals[i]).norm() < kNormalTolerance);
    }
}

void TestDeformColumns::fitsItsResultToWhatItIsGiven()
{
    VertexColumns moved = columnsOf(lung());
    const TriangleMesh few = test::lungLikeMesh(Vec3::Zero(), Vec3::Constant(0.05), 3, 4);
    deformColumns(columnsOf(few), adultChest(), {}, moved);
    QCOMPARE(moved.size(), few.positions.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QCOMPARE(moved.position[axis].size(), few.positions.size());
        QCOMPARE(moved.normal[axis].size(), few.positions.size());
    }
    QVERIFY((at(moved.position, 2) - few.positions[2]).norm() < kTolerance_m);
    deformColumns({}, adultChest(), {}, moved);
    QCOMPARE(moved.size(), std::size_t{0});
}

CARINA_TEST(TestDeformColumns)

} // namespace carina::deform_columns_test

#include "tst_deform_columns.moc"
