#include "models/objects/object_action_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <numbers>

namespace carina::object_action_model_test
{

using test::FakeSessionNode;

class TestObjectActionModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsMovesAndScales_data();
    void turnsMovesAndScales();
    void stopsWhereItIsByThen();
    void bringsItBackToItsPlace();
    void offersOnlyWhatChangesSomething();
    void offersNothingToWhomItDoesNotBelong();
    void offersNothingBeforeTheClockIsSet();
    void keepsASpeedForEachKindWithinItsBounds();
    void tellsWhatOthersDo_data();
    void tellsWhatOthersDo();
    void tellsWhenItsOwnerIsSilent();
    void tellsByItselfThatSomethingMoves();
};

namespace
{

using std::chrono::seconds;
using Axis = ObjectActionModel::Axis;

constexpr ObjectId kPatient = FakeSessionNode::kPatient;
constexpr double kSmall = 1e-6; ///< of rates, which travel as 32-bit numbers: metres, radians, 1

struct Seat {
    FakeSessionNode node;
    SessionModel session{node};
    SharedObjectModel object{session, FakeSessionNode::kStation};
    ObjectActionModel model{object};

    explicit Seat(ParticipantId owner = FakeSessionNode::kInstructor) { node.sharePatient(owner); }
    [[nodiscard]] ActedPose patient() const { return node.shown(kPatient, *node.now())->acted; }
    /// Turns it about z, and goes on.
    void turn(double speed, Duration time)
    {
        model.setKind(ActionKind::Rotation);
        model.setSpeed(speed);
        model.start();
        node.advance(time);
    }
};

} // namespace

void TestObjectActionModel::turnsMovesAndScales_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("speed");
    QTest::addColumn<QList<double>>("place"); ///< after two seconds: rotation vector, way, size
    QTest::addColumn<QString>("motion");
    const double third = std::numbers::pi / 3.0; // 60 degrees
    const auto row = [](const char* name, ActionKind kind, Axis axis, double speed,
                        const QList<double>& place, const char* motion) {
        QTest::newRow(name) << int(kind) << int(axis) << speed << place
                            << QString::fromUtf8(motion);
    };
    row("turn about x", ActionKind::Rotation, Axis::X, 30.0, {third, 0, 0, 0, 0, 0, 1},
        "● Turns about x at 30.0 °/s");
    row("turn about z the other way", ActionKind::Rotation, Axis::Z, -30.0,
        {0, 0, -third, 0, 0, 0, 1}, "● Turns about z at -30.0 °/s");
    row("move along y", ActionKind::Translation, Axis::Y, 50.0, {0, 0, 0, 0, 0.1, 0, 1},
        "● Moves along y at 50.0 mm/s");
    row("grow by a tenth each second", ActionKind::Scaling, Axis::Y, 10.0, {0, 0, 0, 0, 0, 0, 1.21},
        "● Changes its size by 10.0 %/s");
    row("shrink to the half each second", ActionKind::Scaling, Axis::X, -50.0,
        {0, 0, 0, 0, 0, 0, 0.25}, "● Changes its size by -50.0 %/s");
}

void TestObjectActionModel::turnsMovesAndScales()
{
    QFETCH(int, kind);
    QFETCH(int, axis);
    QFETCH(double, speed);
    QFETCH(QList<double>, place);
    QFETCH(QString, motion);
    Seat seat;
    QCOMPARE(seat.model.motionText(), QStringLiteral("■ At rest"));
    seat.model.setKind(static_cast<ActionKind>(kind));
    seat.model.setAxis(static_cast<Axis>(axis));
    seat.model.setSpeed(speed);
    seat.model.start();
    QCOMPARE(seat.model.motionText(), motion);
    seat.node.advance(seconds{2});
    const ActedPose patient = seat.patient();
    const Eigen::AngleAxisd turned{patient.X_AO.rotation()};
    QVERIFY((turned.angle() * turned.axis() - Vec3(place[0], place[1], place[2])).norm() < kSmall);
    QVERIFY((patient.X_AO.translation() - Vec3(place[3], place[4], place[5])).norm() < kSmall);
    QVERIFY(std::abs(patient.scale - place[6]) < kSmall);
}

void TestObjectActionModel::stopsWhereItIsByThen()
{
    Seat seat;
    seat.turn(100.0, seconds{1});
    seat.model.stop();
    QCOMPARE(seat.model.motionText(), QStringLiteral("■ At rest"));
    seat.node.advance(seconds{5});
    QCOMPARE(
        seat.model.placeText(),
        QStringLiteral(
            "▲ Away from its original place: turned 100.0°, moved 0.0\u00a0mm, size 100.0\u00a0%"));
}

void TestObjectActionModel::bringsItBackToItsPlace()
{
    Seat seat;
    seat.turn(100.0, seconds{1});
    seat.model.setKind(ActionKind::Translation);
    seat.model.start();
    seat.node.advance(seconds{1});
    seat.model.setKind(ActionKind::Scaling);
    seat.model.start();
    seat.node.advance(seconds{1});
    QVERIFY(!seat.model.isInPlace());
    seat.model.reset();
    QVERIFY(seat.model.isInPlace());
    QCOMPARE(seat.model.placeText(), QStringLiteral("In its original place"));
    QCOMPARE(seat.model.motionText(), QStringLiteral("■ At rest"));
    seat.node.advance(seconds{1});
    QVERIFY(seat.patient().X_AO.matrix() == RigidTransform{}.matrix());
    QCOMPARE(seat.patient().scale, 1.0);
}

void TestObjectActionModel::offersOnlyWhatChangesSomething()
{
    Seat seat;
    const auto offered = [&seat] {
        return QByteArray{seat.model.canStart() ? "start " : "- "}
               + (seat.model.canStop() ? "stop " : "- ") + (seat.model.canReset() ? "reset" : "-");
    };
    QCOMPARE(offered(), QByteArray{"start - -"});
    seat.turn(100.0, seconds{1});
    QCOMPARE(offered(), QByteArray{"- stop reset"}); // just this goes on
    seat.model.setSpeed(90.0);
    QCOMPARE(offered(), QByteArray{"start stop reset"});
    seat.model.setSpeed(0.0);
    QCOMPARE(offered(), QByteArray{"- stop reset"});
    seat.model.setSpeed(100.0);
    seat.model.setAxis(Axis::X);
    QCOMPARE(offered(), QByteArray{"start stop reset"});
    seat.model.setAxis(Axis::Z);
    seat.model.stop();
    QCOMPARE(offered(), QByteArray{"start - reset"});
    seat.model.reset();
    QCOMPARE(offered(), QByteArray{"start - -"});
    seat.model.setKind(ActionKind::Scaling);
    QVERIFY(!seat.model.hasAxis());
    seat.model.start();
    seat.model.setAxis(Axis::Y); // which scaling does not have
    QCOMPARE(offered(), QByteArray{"- stop reset"});
}

void TestObjectActionModel::offersNothingToWhomItDoesNotBelong()
{
    Seat seat{FakeSessionNode::kTrainee};
    seat.node.ownerActs(kPatient, {ActionKind::Rotation, Vec3::UnitZ(), 1.0});
    seat.node.advance(seconds{1});
    QVERIFY(!seat.model.canStart() && !seat.model.canStop() && !seat.model.canReset());
    seat.model.start();
    seat.model.stop();
    seat.model.reset();
    QVERIFY(!seat.node.refusal()); // nothing was even tried
    QCOMPARE(seat.node.shown(kPatient, *seat.node.now())->rate, 1.0);
    seat.object.takeOver();
    QVERIFY(seat.model.canStart() && seat.model.canStop() && seat.model.canReset());
    QCOMPARE(seat.node.shown(kPatient, *seat.node.now())->rate, 1.0); // goes on
}

void TestObjectActionModel::offersNothingBeforeTheClockIsSet()
{
    Seat seat;
    seat.node.loseClock();
    QVERIFY(!seat.model.canStart() && !seat.model.canStop() && !seat.model.canReset());
}

void TestObjectActionModel::keepsASpeedForEachKindWithinItsBounds()
{
    Seat seat;
    QSignalSpy changes{&seat.model, &ObjectActionModel::changed};
    seat.model.setSpeed(1e6);
    QCOMPARE(changes.size(), 1);
    QCOMPARE(seat.model.speed(), 360.0);
    QCOMPARE(ObjectActionModel::speedScale(ActionKind::Rotation).unit, QStringLiteral("°/s"));
    seat.model.setKind(ActionKind::Translation);
    seat.model.setSpeed(-1e6);
    QCOMPARE(seat.model.speed(), -200.0);
    QCOMPARE(ObjectActionModel::speedScale(ActionKind::Translation).unit, QStringLiteral("mm/s"));
    seat.model.setKind(ActionKind::Scaling);
    seat.model.setSpeed(1e6);
    QCOMPARE(seat.model.speed(), 50.0);
    QCOMPARE(ObjectActionModel::speedScale(ActionKind::Scaling).unit, QStringLiteral("%/s"));
    seat.model.setKind(ActionKind::Rotation);
    QCOMPARE(seat.model.speed(), 360.0);
}

void TestObjectActionModel::tellsWhatOthersDo_data()
{
    QTest::addColumn<Vec3>("axis_A");
    QTest::addColumn<QString>("motion");
    const double turn = std::numbers::pi / 2.0;
    QTest::newRow("against an axis")
        << Vec3{-turn * Vec3::UnitY()} << QStringLiteral("● Turns about y at -90.0 °/s");
    QTest::newRow("askew") << Vec3{turn * Vec3{0.6, -0.8, 0.0}}
                           << QStringLiteral("● Turns about (0.60, -0.80, 0.00) at 90.0 °/s");
}

void TestObjectActionModel::tellsWhatOthersDo()
{
    QFETCH(Vec3, axis_A);
    QFETCH(QString, motion);
    Seat seat{FakeSessionNode::kTrainee};
    seat.node.ownerActs(kPatient, {ActionKind::Rotation, axis_A.normalized(), axis_A.norm()});
    QCOMPARE(seat.model.motionText(), motion);
}

void TestObjectActionModel::tellsWhenItsOwnerIsSilent()
{
    Seat seat{FakeSessionNode::kTrainee};
    seat.node.ownerActs(kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.01});
    seat.node.silence(std::chrono::milliseconds{301});
    QCOMPARE(seat.model.motionText(),
             QStringLiteral("● Moves along x at 10.0 mm/s (no data from its owner)"));
}

void TestObjectActionModel::tellsByItselfThatSomethingMoves()
{
    Seat seat;
    QSignalSpy changes{&seat.model, &ObjectActionModel::changed};
    QVERIFY(changes.wait()); // it looked for the first time
    seat.turn(100.0, seconds{1});
    changes.clear();
    QVERIFY(changes.wait());
    seat.model.reset();
    changes.clear();
    seat.node.decide(fact::ObjectHandedOver{kPatient, FakeSessionNode::kTrainee, 1});
    QVERIFY(changes.wait());
}

CARINA_TEST(TestObjectActionModel)

} // namespace carina::object_action_model_test

#include "tst_object_action_model.moc"
