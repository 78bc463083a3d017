#include "engine/geometry/mesh/mesh_repair.h"
#include "engine/geometry/mesh/mesh_weld.h"
#include "engine/lungs/mechanics/lung_pair.h"
#include "tests/engine/geometry/mesh/plain_obj.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <Eigen/LU>

namespace carina::real_chest_test
{

namespace
{

constexpr Length kWeld = millimetres(0.01);
constexpr double kNormalTolerance_deg = 0.5;
constexpr double kVolumeTolerance_ml = 0.1;
constexpr double kLeastDeterminant = 0.1;
constexpr double kStep_m = 1e-5;

/// The five lobes of a man, closed, in the frame of their files moved to the middle of both lungs.
Anatomy realLobes(const std::filesystem::path& folder)
{
    const std::array<std::pair<const char*, PartRole>, 5> files{
        {{"right_upper_lobe", PartRole::RightUpperLobe},
         {"right_middle_lobe", PartRole::RightMiddleLobe},
         {"right_lower_lobe", PartRole::RightLowerLobe},
         {"left_upper_lobe", PartRole::LeftUpperLobe},
         {"left_lower_lobe", PartRole::LeftLowerLobe}}};
    Anatomy anatomy;
    Box box;
    for (const auto& [name, role] : files) {
        TriangleMesh lobe = closedSurface(
            welded(test::plainObj(folder / (std::string{name} + ".obj")), kWeld), kWeld);
        computeNormals(lobe);
        box.include(boundsOf(lobe));
        anatomy.parts.push_back({name, role, {}, {std::move(lobe)}});
    }
    for (AnatomyPart& part : anatomy.parts)
        for (Vec3f& p : part.levels.front().positions)
            p -= box.centre().cast<float>();
    return anatomy;
}

double angle_deg(const Vec3& a, const Vec3& b)
{
    return inDegrees(radians(std::atan2(a.cross(b).norm(), a.dot(b))));
}

} // namespace

/// The field on lungs as they are, where their files are at hand.
class TestRealChest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void turnsNormalsAsTheSurfaceTurns_data() { poses(); }
    void turnsNormalsAsTheSurfaceTurns();
    void foldsNowhere_data() { poses(); }
    void foldsNowhere();
    void drawsTheVolumeAskedFor_data();
    void drawsTheVolumeAskedFor();

private:
    static void poses();

    std::optional<LungPair> m_lungs;
};

void TestRealChest::initTestCase()
{
    const auto folder = test::testData("anatomy/lungs");
    if (!folder)
        return;
    m_lungs = LungPair::of(realLobes(*folder)).value();
}

void TestRealChest::init()
{
    if (!test::testData("anatomy/lungs"))
        QSKIP("the real lungs are not here");
}

void TestRealChest::poses()
{
    QTest::addColumn<ChestPose>("pose");
    const auto both = [](const LungPose& lung) { return ChestPose{{lung, lung}, 0.0}; };
    QTest::newRow("quiet breath") << both(2.5 * kQuietBreath);
    QTest::newRow("as deep as can be") << both(kMostDescent * kQuietBreath);
    QTest::newRow("breathed out") << both(kLeastBreath * kQuietBreath);
    QTest::newRow("right lung collapsed")
        << ChestPose{{LungPose{.collapse = kMostCollapse}, 3.0 * kQuietBreath}, 0.1};
}

void TestRealChest::turnsNormalsAsTheSurfaceTurns()
{
    QFETCH(ChestPose, pose);
    const ChestField& field = m_lungs->field();
    for (const BreathingPart& part : m_lungs->parts()) {
        const ChestMotion motion = motionOf(part.region, pose, field);
        const TriangleMesh& rest = part.levels.front();
        const TriangleMesh moved = deformed(rest, field, motion);
        for (std::size_t i = 0; i < rest.positions.size(); ++i) {
            const Vec3 p_A = rest.positions[i].cast<double>();
            const Vec3 n = rest.normals[i].cast<double>();
            const auto along = [&](const Vec3& d) {
                return Vec3{2.0 * kStep_m * d + field.at(p_A + kStep_m * d, motion).d_A
                            - field.at(p_A - kStep_m * d, motion).d_A};
            };
            const Vec3 s = n.unitOrthogonal();
            const Vec3 expected = along(s).cross(along(n.cross(s)));
            QVERIFY(angle_deg(moved.normals[i].cast<double>(), expected) < kNormalTolerance_deg);
        }
    }
}

void TestRealChest::foldsNowhere()
{
    QFETCH(ChestPose, pose);
    QVERIFY(rangeTaken(pose) <= 1.0 + 1e-12);
    for (const BreathingPart& part : m_lungs->parts()) {
        const ChestMotion motion = motionOf(part.region, pose, m_lungs->field());
        for (const Vec3f& p_A : part.levels.front().positions) {
            const Mat3 gradient = m_lungs->field().at(p_A.cast<double>(), motion).gradient;
            QVERIFY((Mat3::Identity() + gradient).determinant() > kLeastDeterminant);
        }
    }
}

void TestRealChest::drawsTheVolumeAskedFor_data()
{
    QTest::addColumn<double>("inspired_ml");
    for (const double inspired_ml : {-400.0, 0.0, 280.0, 540.0, 1500.0})
        QTest::addRow("%g ml", inspired_ml) << inspired_ml;
}

void TestRealChest::drawsTheVolumeAskedFor()
{
    QFETCH(double, inspired_ml);
    const ChestPose pose = m_lungs->pose(millilitres(inspired_ml), 0).value();
    std::array<double, 2> drawn_ml{};
    for (const BreathingPart& part : m_lungs->parts())
        drawn_ml[indexOf(part.side)] +=
            1e6
            * test::volumeByColumns(deformed(part.levels.front(), m_lungs->field(),
                                             motionOf(part.region, pose, m_lungs->field())));
    for (const Side side : {Side::Right, Side::Left}) {
        const double asked_ml = inMillilitres(m_lungs->volumeWith(millilitres(inspired_ml), side));
        QVERIFY(std::abs(drawn_ml[indexOf(side)] - asked_ml) < kVolumeTolerance_ml);
    }
}

CARINA_TEST(TestRealChest)

} // namespace carina::real_chest_test

#include "tst_real_chest.moc"
