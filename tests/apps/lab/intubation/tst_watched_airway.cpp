#include "apps/lab/intubation/watched_airway.h"

#include "engine/anatomy/airway/centreline.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <array>

namespace carina::lab::watched_airway_test
{
namespace
{

constexpr double kSection = 4e-3; ///< metres of the way
constexpr double kRadius = 10e-3; ///< metres, of a round lumen
constexpr Length kAside = millimetres(12.0);
constexpr Length kInTrachea = millimetres(7.0); ///< of a rod's tip from the middle of it
constexpr Length kNear = millimetres(4.0);      ///< both tips of a tube that fits
constexpr int kMoments = 50;
constexpr Duration kEach = std::chrono::milliseconds{20};
constexpr SessionTime kBegins{std::chrono::seconds{10}};

/// Round, along the middle of the airway to the carina.
std::shared_ptr<const AirwayLumen> roundLumenOf(const IntubationSubject& subject)
{
    const TipWay& way = subject.motion->way(TipTarget::Trachea);
    std::array<std::vector<Vec3>, kAirwayWays> lines;
    std::array<std::vector<double>, kAirwayWays> radii;
    for (double along = 0.0; along < way.end; along += kSection) {
        lines.front().push_back(pointAlong(way.line_A, metres(along)));
        radii.front().push_back(kRadius);
    }
    AirwayLumen lumen = test::roundLumen(lines, radii, 0.5 * subject.tube.outerDiameter);
    lumen.teeth = std::size_t(way.teeth / kSection);
    lumen.glottis = std::size_t(way.gate / kSection);
    return std::make_shared<const AirwayLumen>(std::move(lumen));
}

IntubationSubject boy()
{
    const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
    IntubationSubject subject =
        intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {}).value();
    subject.lumen = roundLumenOf(subject);
    return subject;
}

/// After a second in which the tube lies at its final depth, so far to the patient's left.
AirwayMoment rested(const IntubationSubject& subject, Length left)
{
    const RigidTransform X_AE =
        RigidTransform::translation({left.si, 0.0, 0.0}) * subject.tube.X_AE;
    WatchedAirway airway{subject, motionBlade(subject.motion->upper),
                         [&](SessionTime) { return std::optional{X_AE}; }};
    AirwayMoment moment;
    for (int i = 0; i < kMoments; ++i) {
        const SessionTime t = kBegins + i * kEach;
        moment = airway.take(
            {.tube = {.time = t, .X_FO = X_AE, .validity = Validity::Tracked},
             .laryngoscope = {.time = t, .X_FO = {}, .validity = Validity::Lost},
             .jaw = {.time = t, .X_FO = subject.motion->held, .validity = Validity::Tracked},
             .head = {}});
    }
    return moment;
}

Length fromTrachea(const IntubationSubject& subject, const AirwayMoment& moment)
{
    return nearestOnWay(subject.ways.trachea, moment.p_A_tip).off;
}

} // namespace

class TestWatchedAirway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsATubeBesideTheTracheaInIt()
    {
        const IntubationSubject subject = boy();
        const AirwayMoment end = rested(subject, kAside);
        QVERIFY(fromTrachea(subject, end) < kInTrachea);
        QVERIFY(end.besides > kAside - kInTrachea);
    }

    void showsATubeThatFitsWhereItWasMeasured()
    {
        const AirwayMoment end = rested(boy(), {});
        QVERIFY(end.pastCords > Length{});
        QVERIFY2(end.besides < kNear, qPrintable(QString::number(inMillimetres(end.besides))));
    }

    void showsItAsMeasuredWhereThereIsNoLumen()
    {
        IntubationSubject subject = boy();
        subject.lumen = nullptr;
        const AirwayMoment end = rested(subject, kAside);
        QCOMPARE(end.besides, Length{});
        QVERIFY(fromTrachea(subject, end) > kInTrachea);
    }

    void measuresTheLumenOfATubeThatBends()
    {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        const IntubationSubject subject =
            intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {},
                              TubeBending::Elastic)
                .value();
        QCOMPARE(subject.lumen->tubeRadius, 0.5 * subject.tube.outerDiameter);
    }

    void measuresTheLumenOfATubeThatWasTouched()
    {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        const Anatomy anatomy = test::tubePatient(dimensions);
        IntubationSubject subject = intubationSubject(anatomy, buildOf(dimensions), {}).value();
        QVERIFY(!subject.lumen);
        const std::array straight{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -0.28}};
        takeTube(subject, anatomy, tubeAlong(subject.tube, straight, millimetres(8.2)));
        QCOMPARE(inMillimetres(subject.innerDiameter), 6.0);
        QCOMPARE(subject.lumen->tubeRadius, 0.5 * millimetres(8.2));
    }
};

CARINA_TEST(TestWatchedAirway)

} // namespace carina::lab::watched_airway_test

#include "tst_watched_airway.moc"
