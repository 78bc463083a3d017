#include "models/patient/shared_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::shared_patient_test
{

using test::FakeSessionNode;

class TestSharedPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sharesThePatientOnce();
    void knowsTheSmallestDisplacementItTells_data();
    void knowsTheSmallestDisplacementItTells();
};

namespace
{

constexpr double kSmall = 1e-9; ///< degrees, millimetres, per cent

} // namespace

void TestSharedPatient::sharesThePatientOnce()
{
    FakeSessionNode node;
    QVERIFY(!sharedPatient(*node.state(), FakeSessionNode::kStation));
    sharePatient(node, FakeSessionNode::kStation, "Adult");
    sharePatient(node, FakeSessionNode::kStation, "Adult");
    QCOMPARE(node.proposed, 1);
    const auto state = node.state();
    const SharedObject* patient = sharedPatient(*state, FakeSessionNode::kStation);
    QVERIFY(patient && patient->id == FakeSessionNode::kPatient && patient->name == "Adult");
    QVERIFY(patient->owner == FakeSessionNode::kInstructor);
    QVERIFY(!sharedPatient(*state, StationId{7}));
}

void TestSharedPatient::knowsTheSmallestDisplacementItTells_data()
{
    QTest::addColumn<double>("deg");
    QTest::addColumn<double>("mm");
    QTest::addColumn<double>("percent");
    QTest::addColumn<bool>("inPlace");
    QTest::newRow("home") << 0.0 << 0.0 << 100.0 << true;
    QTest::newRow("nearly") << 0.049 << 0.049 << 100.049 << true;
    QTest::newRow("turned") << 0.051 << 0.0 << 100.0 << false;
    QTest::newRow("moved") << 0.0 << 0.051 << 100.0 << false;
    QTest::newRow("larger") << 0.0 << 0.0 << 100.051 << false;
    QTest::newRow("smaller") << 0.0 << 0.0 << 99.949 << false;
}

void TestSharedPatient::knowsTheSmallestDisplacementItTells()
{
    QFETCH(double, deg);
    QFETCH(double, mm);
    QFETCH(double, percent);
    QFETCH(bool, inPlace);
    const Quat turned{Eigen::AngleAxisd{degrees(deg).si, Vec3::UnitY()}};
    const ActedPose acted{RigidTransform{turned, Vec3{0.0, 0.0, 1e-3 * mm}}, 0.01 * percent};
    QCOMPARE(isInItsPlace(acted), inPlace);
    const Displacement displacement = displacementOf(acted);
    QVERIFY(std::abs(displacement.turned_deg - deg) < kSmall);
    QVERIFY(std::abs(displacement.moved_mm - mm) < kSmall);
    QVERIFY(std::abs(displacement.size_percent - percent) < kSmall);
}

CARINA_TEST(TestSharedPatient)

} // namespace carina::shared_patient_test

#include "tst_shared_patient.moc"
