#include "engine/registration/error/target_error.h"
#include "engine/registration/fit/manikin_fit.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>

namespace carina::registration_coverage_test
{
namespace
{

constexpr int kRegistrations = 1000;
constexpr double kHand = 0.8e-3;        // m along each axis: how far a touch is from the landmark
constexpr double kTracker = 0.1e-3;     // m along each axis: noise of each sample
constexpr Angle kLean = degrees(20.0);  // of the stylus from touch to touch, RMS
constexpr double kStandardErrors = 4.0; // of a share that is counted, beside theory
/// By how much a share may leave what was recorded: three standard errors of a share counted in so
/// many, where it is 0.9 or more; four fifths of that where it is about half.
constexpr double kRecorded = 0.035;
constexpr Duration kPeriod = std::chrono::microseconds{16'667};

/// How touches stray, and how the manikin differs from the patient. As given here: by kHand along
/// each axis, each touch on its own, on a manikin that is the patient.
struct Circumstances {
    Vec3 hand = Vec3::Constant(kHand); ///< deviations along the axes of A, m
    Vec3 tip_S = Vec3::Zero();         ///< the tip is off its calibrated place, m
    std::vector<Vec3> slides_A{};      ///< of each landmark's skin, the same each time, m
    double size = 1.0;                 ///< of the manikin over the patient
};

/// Deviations of the same length as kHand along each axis, three times as large along one.
Vec3 elongated(int axis)
{
    Vec3 deviations = Vec3::Ones();
    deviations[axis] = 3.0;
    return kHand * std::sqrt(3.0) / deviations.norm() * deviations;
}

/// The skin over each landmark slides by a millimetre along the surface, away from the middle of
/// the body: a tip that is pressed on a rounded place slides down its slope.
std::vector<Vec3> slidesOutwards()
{
    std::vector<Vec3> slides;
    for (const Vec3& p : test::kEightLandmarks)
        slides.push_back(1e-3 * Vec3{p.x(), 0.0, p.z()}.normalized());
    return slides;
}

/// The skin everywhere slides by a millimetre towards the feet, as somebody who stands at the head
/// pushes it.
std::vector<Vec3> slidesAway()
{
    return std::vector<Vec3>(test::kEightLandmarks.size(), Vec3{0.0, 0.0, -1e-3});
}

/// A technician who touches the landmarks one after another with a tracked stylus, in a time of
/// their own.
class Technician
{
public:
    explicit Technician(unsigned seed, Circumstances circumstances = {})
        : m_hand{seed}, m_how{std::move(circumstances)}
    {
    }

    /// One registration of a manikin in a new place.
    Result<ManikinFit> registers(const std::vector<Vec3>& p_A)
    {
        m_X_TA = m_hand.pose();
        DwellDetector detector;
        std::vector<TouchedLandmark> landmarks;
        for (std::size_t i = 0; i < p_A.size(); ++i) {
            const Vec3 p_TQ = m_X_TA * touched(p_A[i], i);
            std::optional<DwellPoint> point;
            while (!point) {
                m_now += kPeriod;
                point = detector.push(m_now, p_TQ + kTracker * m_hand.unit(), Validity::Tracked);
            }
            landmarks.push_back({p_A[i], point->p_FQ});
        }
        return fitManikin(landmarks);
    }

    /// How far the anatomy lies from its place at a target.
    [[nodiscard]] double errorAt(const ManikinFit& fit, const Vec3& p_AQ) const
    {
        return (fit.X_AT() * (m_X_TA * Vec3{m_how.size * p_AQ}) - p_AQ).norm();
    }

private:
    /// Where the stylus takes the landmark to be, in axes of A.
    Vec3 touched(const Vec3& p_AQ, std::size_t landmark)
    {
        Vec3 p_A = m_how.size * p_AQ + m_how.hand.cwiseProduct(m_hand.unit());
        if (!m_how.slides_A.empty())
            p_A += m_how.slides_A[landmark];
        if (!m_how.tip_S.isZero()) // held at much the same slant
            p_A += rotationFromVector(kLean.si / std::sqrt(3.0) * m_hand.unit()) * m_how.tip_S;
        return p_A;
    }

    test::Hand m_hand;
    Circumstances m_how;
    RigidTransform m_X_TA;
    SessionTime m_now{};
};

/// How a thousand registrations turn out at one target.
struct Tally {
    Length trueRms;   ///< by theory, from the errors truly made
    TargetError unit; ///< for an FLE of one metre: all of it grows with the FLE
    std::vector<double> errors{};
    double bounds = 0.0; ///< sums
    double limits = 0.0;
    int boundHeld = 0;
    int limitHeld = 0;

    /// @param predicted for an FLE of one metre with the degrees of freedom of this one
    void add(double error, const LocalisationError& fle, const TargetError& predicted)
    {
        const double bound = fle.rms.si * predicted.bound.si;
        const double limit = fle.limit().si * unit.rms.si;
        errors.push_back(error);
        bounds += bound;
        limits += limit;
        boundHeld += error < bound ? 1 : 0;
        limitHeld += trueRms.si < limit ? 1 : 0;
    }

    [[nodiscard]] double rms() const
    {
        double squares = 0.0;
        for (const double error : errors)
            squares += error * error / kRegistrations;
        return std::sqrt(squares);
    }
    /// What 95 % of the errors are below: the least that a bound of 95 % can be.
    [[nodiscard]] double leastBound() const
    {
        std::vector<double> sorted = errors;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() * 95 / 100];
    }
};

std::vector<Tally> talliesFor(const std::vector<Vec3>& p_A, double degrees)
{
    const double fle = std::sqrt(3.0 * (kHand * kHand + kTracker * kTracker / 60.0));
    const auto perMetre = fitCovariance(equalErrors(p_A, metres(1.0)));
    std::vector<Tally> tallies;
    for (const Vec3& target : test::kTargets) {
        const TargetError unit = targetError(*perMetre, target, degrees);
        tallies.push_back({.trueRms = fle * unit.rms, .unit = unit});
    }
    return tallies;
}

/// A thousand registrations, each with the bound that its residuals and earlier ones promise.
/// @param leftOut how many earlier ones were not pooled
std::vector<Tally> registered(Technician& technician, int count, int earlier, int& leftOut)
{
    const std::vector<Vec3> p_A = test::firstLandmarks(count);
    std::vector<Tally> tallies = talliesFor(p_A, (3.0 * count - 6.0) * (1.0 + earlier));
    const std::vector<Tally> alone = talliesFor(p_A, 3.0 * count - 6.0);
    for (int i = 0; i < kRegistrations; ++i) {
        std::vector<LocalisationError> own;
        Result<ManikinFit> fit = fail(Errc::NotRegistered);
        for (int k = 0; k <= earlier; ++k) {
            fit = technician.registers(p_A);
            own.push_back(localisationError(metres(fit->fit.rms), p_A.size()));
        }
        const LocalisationError now = own.back();
        own.pop_back();
        const PooledLocalisation found = pooled(now, own);
        leftOut += found.disagreeing;
        for (std::size_t t = 0; t < tallies.size(); ++t)
            tallies[t].add(technician.errorAt(*fit, test::kTargets[t]), found.fle,
                           found.disagreeing == 0 ? tallies[t].unit : alone[t].unit);
    }
    return tallies;
}

/// The place of the first-order error of a fit: its rotation (about the middle of the landmarks)
/// and its translation are independent and normal, for touches that stray alike in all directions.
class TheoreticalError
{
public:
    /// @param touch deviation along each axis, m
    TheoreticalError(const std::vector<Vec3>& p_A, double touch)
    {
        for (const Vec3& p : p_A)
            m_middle += p / double(p_A.size());
        Mat3 inertia = Mat3::Zero();
        for (const Vec3& p : p_A) {
            const Vec3 arm = p - m_middle;
            inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
        }
        m_turn = test::factorOf(touch * touch * inertia.inverse());
        m_shift = touch / std::sqrt(double(p_A.size()));
    }

    [[nodiscard]] Vec3 at(const Vec3& target, test::Hand& hand) const
    {
        const Vec3 turn = hand.error(m_turn);
        return m_shift * hand.unit() + turn.cross(target - m_middle);
    }

private:
    Vec3 m_middle = Vec3::Zero();
    Mat3 m_turn;
    double m_shift = 0.0;
};

/// How often the 95 % bound holds where all touches are off by `shared`: the fit takes the shift up
/// whole, and its residuals, with 3 N - 6 degrees of freedom, do not know of it.
/// @param unit the target's error for an FLE of one metre
double shareByTheory(const std::vector<Vec3>& p_A, const Vec3& target, const Vec3& shared,
                     const TargetError& unit)
{
    constexpr int kDrawn = 100'000;
    const double touch = std::sqrt(kHand * kHand + kTracker * kTracker / 60.0);
    const double degrees = 3.0 * double(p_A.size()) - 6.0;
    const TheoreticalError error{p_A, touch};
    test::Hand hand{149};
    std::chi_squared_distribution<double> squares{degrees};
    int held = 0;
    for (int i = 0; i < kDrawn; ++i) {
        const double fle = std::sqrt(3.0 * squares(hand.random()) / degrees) * touch;
        held += (shared + error.at(target, hand)).norm() < fle * unit.bound.si ? 1 : 0;
    }
    return double(held) / kDrawn;
}

bool isNinetyFivePercent(int held)
{
    return held >= 0.935 * kRegistrations && held <= 0.965 * kRegistrations;
}

} // namespace

/// A thousand whole registrations, by people who make errors.
class TestRegistrationCoverage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void promisesWhatItKeeps_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("earlier"); // registrations by the same hand whose residuals count
        QTest::addColumn<double>("overRms");
        // The limit of the RMS error over the RMS error: the root of nu over the 5 % quantile of
        // chi-squared with nu = (3 N - 6) (1 + earlier) degrees of freedom, and a little for what
        // differs from theory in a thousand.
        QTest::newRow("four landmarks") << 4 << 0 << 1.95;
        QTest::newRow("six landmarks") << 6 << 0 << 1.55;
        QTest::newRow("eight landmarks") << 8 << 0 << 1.42;
        QTest::newRow("eight landmarks, one earlier registration") << 8 << 1 << 1.3;
    }

    void promisesWhatItKeeps()
    {
        QFETCH(int, count);
        QFETCH(int, earlier);
        QFETCH(double, overRms);
        int leftOut = 0;
        Technician technician{137};
        const std::vector<Tally> tallies = registered(technician, count, earlier, leftOut);
        QVERIFY(leftOut <= 0.02 * kRegistrations);
        for (std::size_t t = 0; t < tallies.size(); ++t) {
            const Tally& tally = tallies[t];
            const double bound = tally.bounds / kRegistrations;
            const double limit = tally.limits / kRegistrations;
            qInfo("%-15s bound held %d, %.2f RMS, %.2f of the least; limit held %d, %.2f RMS",
                  test::kTargetNames[t], tally.boundHeld, bound / tally.rms(),
                  bound / tally.leastBound(), tally.limitHeld, limit / tally.rms());
            QVERIFY(isNinetyFivePercent(tally.boundHeld));
            QVERIFY(bound < 1.3 * tally.leastBound());
            QVERIFY(isNinetyFivePercent(tally.limitHeld));
            QVERIFY(limit < overRms * tally.rms());
        }
    }

    void knowsNothingOfASharedShift_data()
    {
        QTest::addColumn<Circumstances>("how");
        QTest::addColumn<Vec3>("shared"); // what all touches are off by, m
        QTest::addColumn<int>("count");
        // A tip that leans by an RMS angle a in all is across the shaft by 1 - a^2 / 3 of it.
        const double across = 0.5e-3 * (1.0 - kLean.si * kLean.si / 3.0);
        for (const int count : {4, 6, 8}) {
            QTest::addRow("tip 0.5 mm off, %d landmarks", count)
                << Circumstances{.tip_S = {0.5e-3, 0.0, 0.0}} << Vec3{across, 0.0, 0.0} << count;
            QTest::addRow("skin slides to the feet, %d landmarks", count)
                << Circumstances{.slides_A = slidesAway()} << Vec3{0.0, 0.0, -1e-3} << count;
        }
    }

    /// A shift that all touches share displaces every target by itself: at each of them the bound
    /// holds as often as theory says.
    void knowsNothingOfASharedShift()
    {
        QFETCH(Circumstances, how);
        QFETCH(Vec3, shared);
        QFETCH(int, count);
        int leftOut = 0;
        Technician technician{139, how};
        const std::vector<Tally> tallies = registered(technician, count, 0, leftOut);
        for (std::size_t t = 0; t < tallies.size(); ++t) {
            const double expected = shareByTheory(test::firstLandmarks(count), test::kTargets[t],
                                                  shared, tallies[t].unit);
            const double counted = double(tallies[t].boundHeld) / kRegistrations;
            const double standardError =
                std::sqrt(expected * (1.0 - expected) / double(kRegistrations));
            qInfo("%-15s held %.3f, by theory %.3f", test::kTargetNames[t], counted, expected);
            QVERIFY(std::abs(counted - expected) < kStandardErrors * standardError);
        }
    }

    /// Errors of which the residuals know nothing, or something else: how often the bound holds at
    /// the target where it holds least. These shares are a record of what came out, which
    /// docs/registration.md quotes, and no theory's; those of shared shifts have one above.
    void holdsLessWhereItsAssumptionsDoNot_data()
    {
        QTest::addColumn<Circumstances>("how");
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("least"); // share of the registrations, between these
        QTest::addColumn<double>("most");
        const std::vector<std::tuple<const char*, Circumstances, std::array<double, 3>>> cases{
            {"three to one, left to right", {.hand = elongated(0)}, {0.954, 0.900, 0.909}},
            {"three to one, front to back", {.hand = elongated(1)}, {0.746, 0.785, 0.844}},
            {"three to one, head to feet", {.hand = elongated(2)}, {0.979, 0.961, 0.943}},
            {"tip 0.5 mm off", {.tip_S = {0.5e-3, 0.0, 0.0}}, {0.918, 0.885, 0.821}},
            {"skin slides outwards", {.slides_A = slidesOutwards()}, {0.971, 0.988, 0.985}},
            {"skin slides to the feet", {.slides_A = slidesAway()}, {0.893, 0.608, 0.337}},
            {"manikin 3 % larger", {.size = 1.03}, {1.000, 0.999, 0.050}}};
        for (const auto& [name, how, held] : cases)
            for (int i = 0; i < 3; ++i)
                QTest::addRow("%s, %d landmarks", name, 4 + 2 * i)
                    << how << 4 + 2 * i << held[std::size_t(i)] - kRecorded
                    << held[std::size_t(i)] + kRecorded;
    }

    void holdsLessWhereItsAssumptionsDoNot()
    {
        QFETCH(Circumstances, how);
        QFETCH(int, count);
        QFETCH(double, least);
        QFETCH(double, most);
        int leftOut = 0;
        Technician technician{139, how};
        const std::vector<Tally> tallies = registered(technician, count, 0, leftOut);
        QStringList shares;
        double lowest = 1.0;
        for (std::size_t t = 0; t < tallies.size(); ++t) {
            const double share = double(tallies[t].boundHeld) / kRegistrations;
            lowest = std::min(lowest, share);
            shares << QStringLiteral("%1 %2 % (%3 mm RMS)")
                          .arg(QLatin1String{test::kTargetNames[t]})
                          .arg(100.0 * share, 0, 'f', 1)
                          .arg(1e3 * tallies[t].rms(), 0, 'f', 2);
        }
        qInfo("%s: held at %s", QTest::currentDataTag(),
              qPrintable(shares.join(QStringLiteral(", "))));
        QVERIFY(lowest > least);
        QVERIFY(lowest < most);
    }
};

CARINA_TEST(TestRegistrationCoverage)

} // namespace carina::registration_coverage_test

#include "tst_registration_coverage.moc"
