#include "engine/registration/error/target_error.h"
#include "engine/registration/fit/manikin_fit.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include "tests/engine/registration/error/registration_trials.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::registration_coverage_test
{
namespace
{

constexpr int kRegistrations = 1000;
constexpr double kHand = 0.8e-3;    // m along each axis: how far a touch is from the landmark
constexpr double kTracker = 0.1e-3; // m along each axis: noise of each sample
constexpr Duration kPeriod = std::chrono::microseconds{16'667};

/// A technician who touches the landmarks one after another with a tracked stylus, in a time of
/// their own.
class Technician
{
public:
    explicit Technician(unsigned seed) : m_hand{seed} {}

    /// One registration of a manikin in a new place.
    Result<ManikinFit> registers(const std::vector<Vec3>& p_A)
    {
        m_X_TA = m_hand.pose();
        DwellDetector detector;
        std::vector<TouchedLandmark> landmarks;
        for (const Vec3& p_AQ : p_A) {
            const Vec3 p_TQ = m_X_TA * (p_AQ + kHand * m_hand.unit());
            std::optional<DwellPoint> point;
            while (!point) {
                m_now += kPeriod;
                point = detector.push(m_now, p_TQ + kTracker * m_hand.unit(), Validity::Tracked);
            }
            landmarks.push_back({p_AQ, point->p_FQ});
        }
        return fitManikin(landmarks);
    }

    /// How far the anatomy lies from its place at a target.
    [[nodiscard]] double errorAt(const ManikinFit& fit, const Vec3& p_AQ) const
    {
        return (fit.X_AT() * (m_X_TA * p_AQ) - p_AQ).norm();
    }

private:
    test::Hand m_hand;
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

    void add(double error, const LocalisationError& fle)
    {
        const double bound = fle.rms.si * unit.bound.si;
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
        const std::vector<Vec3> p_A = test::firstLandmarks(count);
        std::vector<Tally> tallies = talliesFor(p_A, (3.0 * count - 6.0) * (1.0 + earlier));
        Technician technician{137};
        for (int i = 0; i < kRegistrations; ++i) {
            std::optional<LocalisationError> fle;
            Result<ManikinFit> fit = fail(Errc::NotRegistered);
            for (int k = 0; k <= earlier; ++k) {
                fit = technician.registers(p_A);
                QVERIFY(fit.has_value());
                const auto one = localisationError(metres(fit->fit.rms), p_A.size());
                fle = fle ? pooled(*fle, one) : one;
            }
            QCOMPARE(fle->degrees, (3.0 * count - 6.0) * (1.0 + earlier));
            for (std::size_t t = 0; t < tallies.size(); ++t)
                tallies[t].add(technician.errorAt(*fit, test::kTargets[t]), *fle);
        }
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
};

CARINA_TEST(TestRegistrationCoverage)

} // namespace carina::registration_coverage_test

#include "tst_registration_coverage.moc"
