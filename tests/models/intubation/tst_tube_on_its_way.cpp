#include "engine/airway/tube/rod_guide.h"
#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/net/objects/remote_object.h"
#include "evaluation/intubation/motion_script.h"
#include "models/intubation/distant_tube.h"
#include "models/intubation/intubation_watch.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/patient/lumen_of.h"
#include "tests/support/test_class.h"

#include <QEventLoop>

#include <algorithm>
#include <cmath>

namespace carina::tube_on_its_way_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr double kOutside_m = 1e-3; ///< by which what is drawn may be beyond a wall
constexpr double kThrough_m = 3e-3; ///< by which the rigid tube is, at least
constexpr double kAgree_m = 5e-3;   ///< between what two programs draw
constexpr Duration kEach = 20ms;
constexpr double kOfThroat = 0.6; ///< of the way from the teeth to the cords that is looked at
constexpr double kFrom = 0.2;     ///< of that way, where the tip is at first and in the end
constexpr double kUntil = 0.9;

const Anatomy& anatomy()
{
    static const Anatomy made = builtinPatient(BuiltinPatient::TwelveYears).value();
    return made;
}

/// With a tube that was not touched.
const PatientModel& patient()
{
    static const SharedPatientModel made = patientOf(anatomy()).value();
    return *made;
}

const std::shared_ptr<const MotionPatient>& inMotion()
{
    static const auto made = std::make_shared<const MotionPatient>(
        motionPatient(anatomy(), heldJaw(anatomy().contentHash)).value());
    return made;
}

/// A good intubation, as the simulated tracker plays it.
const IntubationMotion& motion()
{
    static const IntubationMotion made = [] {
        std::mt19937 random = generatorOf(MotionKind::Good, 1);
        const auto parameters = drawnParameters(MotionKind::Good, random);
        const TubeShape& tube = patient().tube();
        return scriptedMotion(MotionKind::Good, parameters, inMotion(),
                              lengthened(tube, tubeOfSize(tube.innerDiameter)->length),
                              std::uint32_t(random()))
            .value();
    }();
    return made;
}

/// The first time at which the tip is so far on its way from the teeth to the cords.
Duration timeAt(double share)
{
    const TipWay& way = inMotion()->way(TipTarget::Trachea);
    Duration t{};
    while (motion().tipAt(t).along < std::lerp(way.teeth, way.gate, share))
        t += kEach;
    return t;
}

/// By how much the points of a line are beyond the walls, in mouth and throat: 0 inside.
double beyondWalls(std::span<const Vec3> line, const MovedLumen& lumen)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    double most = 0.0;
    for (const Vec3& p_A : line) {
        std::size_t segment = trunk.nearestSegment(p_A);
        const double along = trunk.alongAt(p_A, segment);
        if (along <= lumen.teeth || along >= std::lerp(lumen.teeth, lumen.glottis, kOfThroat))
            continue;
        const MovedSection section = lumen.sectionAt(AirwayWay::Trunk, along);
        const Vec3 off = p_A - section.p_A_centre;
        const double u = off.dot(section.side);
        const double v = off.dot(section.back);
        const double share =
            GuideSection{section.p_A_centre, section.side, section.back, section.reach, false}
                .share(u, v);
        if (share > 1.0)
            most = std::max(most, (1.0 - 1.0 / share) * std::hypot(u, v));
    }
    return most;
}

std::vector<Vec3> taken(std::vector<Vec3> line, const RigidTransform& X)
{
    for (Vec3& p : line)
        p = X * p;
    return line;
}

double farthest(std::span<const Vec3> a, std::span<const Vec3> b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

/// At each moment by how much what is drawn lies beyond the walls, and how far apart two programs
/// draw it, metres.
struct Drawn {
    std::vector<double> measured;
    std::vector<double> here;
    std::vector<double> there;
    std::vector<double> apart;
};

double most(const std::vector<double>& values) { return std::ranges::max(values); }

double median(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Who is at work, and another program.
class Programs
{
public:
    explicit Programs(const HeadPosition& head)
        : m_neck{patient().neck(head)}, m_begin{*m_node.now()}
    {
        m_node.decide(fact::HeadPositionSet{head, Duration{}});
        m_watch.lieIn(patient());
        m_distant.lieIn(patient());
        m_held = timeAt(kFrom);
        goOn(200ms);
        waitFor([this](QEventLoop& until) {
            QObject::connect(&m_watch, &IntubationWatch::lumenMeasured, &until, &QEventLoop::quit);
        });
        goOn(200ms);
        (void)m_distant.at(arrived(), tissueAt(arrived()));
        waitFor([this](QEventLoop& until) {
            QObject::connect(&m_distant.lumen(), &PatientLumen::measured, &until,
                             &QEventLoop::quit);
        });
        goOn(200ms);
        m_begin = *m_node.now();
    }

    /// On the way to the cords.
    [[nodiscard]] Drawn look()
    {
        m_held.reset();
        m_first = timeAt(kFrom);
        Drawn drawn;
        while (m_first + (*m_node.now() - m_begin) < timeAt(kUntil)) {
            goOn(kEach);
            const StationMoment moment = ownMoment();
            const RigidTransform& X_AE_now = moment.tube->X_FO;
            const TissueAround tissue = tissueAt(moment);
            const MovedLumen lumen = moved(*m_lumen, tissue.motion, tissue.push);
            const auto here = taken(m_watch.tubeAt(moment, tissue).p_E, X_AE_now);
            const auto there = taken(m_distant.at(arrived(), tissue).p_E, X_AE_now);
            const auto measured = measuredTube(patient(), m_neck, X_AE_now);
            drawn.measured.push_back(beyondWalls(measured, lumen));
            drawn.here.push_back(beyondWalls(here, lumen));
            drawn.there.push_back(beyondWalls(there, lumen));
            drawn.apart.push_back(farthest(here, there));
        }
        return drawn;
    }

private:
    template <class Connect> void waitFor(const Connect& connect)
    {
        QEventLoop until;
        connect(until);
        until.exec();
    }
    [[nodiscard]] RigidTransform X_AE(SessionTime t) const
    {
        const Duration along = m_held ? *m_held : m_first + (t - m_begin);
        return m_neck.X_AU() * motion().at(along).X_AE;
    }
    [[nodiscard]] std::optional<PoseSample> poseOf(ObjectKind kind, SessionTime t) const
    {
        return kind == ObjectKind::Tube ? std::optional{PoseSample{.time = t, .X_FO = X_AE(t)}}
                                        : std::nullopt;
    }
    /// Each pose arrives with the form that is sent at that time.
    void goOn(Duration time)
    {
        const SessionTime until = *m_node.now() + time;
        while (*m_node.now() < until) {
            m_node.advance(kEach);
            m_watch.look();
            StreamCpo cpo;
            cpo.sequence = ++m_sequence;
            cpo.time = *m_node.now();
            cpo.X_AO = X_AE(cpo.time);
            cpo.shape = m_node.shapes.at(ObjectKind::Tube)();
            m_arrived->take(cpo, cpo.time);
        }
    }
    [[nodiscard]] StationMoment moment() const
    {
        StationMoment moment;
        moment.time = *m_node.now();
        moment.worker = FakeSessionNode::kTrainee;
        moment.headPosition = m_neck.position();
        return moment;
    }
    [[nodiscard]] StationMoment ownMoment() const
    {
        StationMoment own = moment();
        own.tube = poseOf(ObjectKind::Tube, own.time);
        return own;
    }
    [[nodiscard]] StationMoment arrived() const
    {
        StationMoment other = moment();
        other.tube = m_arrived->at(other.time);
        other.tubePoses = m_arrived;
        other.tubeShape = m_arrived->shapeAt(other.time);
        return other;
    }
    [[nodiscard]] TissueAround tissueAt(const StationMoment& moment)
    {
        m_throat = throatAt(moment, patient());
        return tissueAround(m_changes, m_throat, m_blade);
    }

    NeckField m_neck;
    AirwayField m_changes;
    FollowingThroat m_throat;
    BladeField m_blade;
    std::shared_ptr<const AirwayLumen> m_lumen = test::lumenOf(patient());
    FakeSessionNode m_node{FakeSessionNode::kTrainee};
    SessionTime m_begin;
    Duration m_first{};
    std::optional<Duration> m_held;
    std::uint16_t m_sequence = 0;
    std::shared_ptr<RemoteObject> m_arrived = std::make_shared<RemoteObject>();
    IntubationWatch m_watch{
        m_node,
        FakeSessionNode::kStation,
        {.at = [this](ObjectKind kind, SessionTime t) { return poseOf(kind, t); },
         .newest = [this](ObjectKind) { return m_node.now(); }}};
    DistantTube m_distant;
};

} // namespace

/// A tube of the simulated tracker, whose curve at rest is the form of the airway.
class TestTubeOnItsWay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isDrawnInTheLumen_data()
    {
        QTest::addColumn<bool>("isFlexed");
        QTest::newRow("neutral") << false;
        QTest::newRow("neck flexed") << true;
    }

    /// By who is at work at each moment, where the rigid tube goes through the walls. Another
    /// program draws the same once the hand rests, which it does for most of this time.
    void isDrawnInTheLumen()
    {
        QFETCH(bool, isFlexed);
        const Drawn drawn = Programs{isFlexed ? kNeckFlexed : HeadPosition{}}.look();
        qInfo("beyond walls: measured %.1f mm, here %.2f mm, there %.2f mm (median); apart %.2f mm "
              "(median)",
              1e3 * most(drawn.measured), 1e3 * most(drawn.here), 1e3 * median(drawn.there),
              1e3 * median(drawn.apart));
        QVERIFY(drawn.here.size() > 50);
        QVERIFY(most(drawn.measured) > kThrough_m);
        QVERIFY(most(drawn.here) < kOutside_m);
        QVERIFY(median(drawn.there) < kOutside_m);
        QVERIFY(median(drawn.apart) < kAgree_m);
    }
};

CARINA_TEST(TestTubeOnItsWay)

} // namespace carina::tube_on_its_way_test

#include "tst_tube_on_its_way.moc"
