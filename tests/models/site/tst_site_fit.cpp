#include "engine/registration/error/registration_error.h"
#include "tests/models/registration/made_site.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <functional>

namespace carina::site_fit_test
{
namespace
{

using namespace test;

constexpr double kAgree = 1e-6; // of an error

/// What a camera tells of a pose: independent errors of the origin and of the turn, standard
/// deviations about and along each axis.
Mat6 toldBy(Angle turn, Length shift)
{
    Vec6 variances;
    variances << Vec3::Constant(turn.si * turn.si), Vec3::Constant(shift.si * shift.si);
    return variances.asDiagonal();
}

/// RMS error of the tip of such a stylus: each of the two axes across its arm turns it.
double errorOfTip(Angle turn, Length shift, const Vec3& p_SQ)
{
    return std::sqrt(3.0 * shift.si * shift.si + 2.0 * turn.si * turn.si * p_SQ.squaredNorm());
}

bool agree(double a, double b) { return std::abs(a / b - 1.0) < kAgree; }

const Angle kTurn = radians(4e-3);
const Length kShift = millimetres(0.3);
const Vec3 kElsewhere{0.3, 0.1, -1.0};

using After = std::function<void(RegistrationSite&)>;

} // namespace

/// The error of a fit whose landmarks were touched without error: it is that of the tracker.
class TestSiteFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsHowTheTouchesWereSeenAndNotHowTheStylusIsNow_data()
    {
        QTest::addColumn<After>("after");
        QTest::newRow("as it was touched") << After{[](RegistrationSite&) {}};
        QTest::newRow("out of view") << After{[](RegistrationSite& site) {
            site.m_now += RegistrationSite::kPeriod;
            PoseSample lost = site.m_tracker.m_stylus.newest().value();
            lost.time = site.m_now;
            lost.validity = Validity::Lost;
            lost.covariance_O.reset();
            site.m_tracker.m_stylus.push(lost);
        }};
        QTest::newRow("silent") << After{
            [](RegistrationSite& site) { site.m_tracker.m_stylus.clear(); }};
        QTest::newRow("far away") << After{[](RegistrationSite& site) {
            site.m_covariance_S = toldBy(10.0 * kTurn, 10.0 * kShift);
            site.tipAt(5.0 * kElsewhere);
        }};
        QTest::newRow("near") << After{[](RegistrationSite& site) {
            site.m_covariance_S = toldBy(0.1 * kTurn, 0.1 * kShift);
            site.tipAt(0.2 * kElsewhere);
        }};
    }

    void knowsHowTheTouchesWereSeenAndNotHowTheStylusIsNow()
    {
        QFETCH(After, after);
        for (const bool isReadAgain : {false, true}) {
            RegistrationSite site;
            auto model = site.model();
            site.prepare(*model);
            site.m_covariance_S = toldBy(kTurn, kShift);
            site.touchFirst(*model, site.landmarks().size());
            after(site);
            if (isReadAgain) {
                model.reset();
                model = site.model();
            }
            model->fitting().fit();
            QVERIFY2(model->site().registration, qPrintable(model->problem()));
            const double truth = errorOfTip(kTurn, kShift, site.p_SQ);
            QVERIFY(truth > 5.0 * kLeastFle.si);
            QVERIFY(agree(model->site().registration->fle, truth));
        }
    }

    /// The mean over the touches, of which some were made farther away.
    void isThatOfEachTouch()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.prepare(*model);
        double squares = 0.0;
        for (std::size_t i = 0; i < 8; ++i) {
            const double far = 1.0 + double(i % 3);
            site.m_covariance_S = toldBy(far * kTurn, far * kShift);
            site.hold(*model, site.X_TA * site.landmarks()[i].p_AQ);
            const double one = errorOfTip(far * kTurn, far * kShift, site.p_SQ);
            QVERIFY(agree(model->site().touched.at(i).seenError.value(), one));
            squares += one * one;
        }
        model->fitting().fit();
        QVERIFY(agree(model->site().registration->fle, std::sqrt(squares / 8.0)));
    }

    void isNotedOfATouchByKey()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.prepare(*model);
        site.m_covariance_S = toldBy(kTurn, kShift);
        for (int i = 0; i < 20; ++i)
            site.tipAt(site.X_TA * site.landmarks()[0].p_AQ);
        model->takeNow();
        QCOMPARE(model->site().touched.size(), std::size_t{1});
        const auto noted = model->site().touched.front().seenError;
        QVERIFY(noted && agree(*noted, errorOfTip(kTurn, kShift, site.p_SQ)));
    }

    /// The right fifth rib is taken for the left one first, which was asked for.
    void goesWithATouchThatIsRenamed()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.prepare(*model);
        const auto factorOf = [](std::size_t landmark) { return 1.0 + double(landmark); };
        for (const std::size_t i : {0U, 1U, 3U, 6U, 4U, 7U, 2U, 5U}) {
            site.m_covariance_S = toldBy(factorOf(i) * kTurn, factorOf(i) * kShift);
            site.hold(*model, site.X_TA * site.landmarks()[i].p_AQ);
            if (i == 3U)
                QVERIFY(touchOf(model->site(), site.landmarks()[2].name));
        }
        for (std::size_t i = 0; i < 8; ++i) {
            const TouchedPoint* touch = touchOf(model->site(), site.landmarks()[i].name);
            QVERIFY2(touch, qPrintable(model->problem()));
            QVERIFY((touch->p_TQ - site.X_TA * site.landmarks()[i].p_AQ).norm() < 1e-6);
            const double one = errorOfTip(factorOf(i) * kTurn, factorOf(i) * kShift, site.p_SQ);
            QVERIFY(agree(touch->seenError.value(), one));
        }
    }

    /// Where no tracker told it, or the file is one of before, the stylus' newest pose counts.
    void takesWhatIsSeenNowWhereNothingWasNoted()
    {
        PoseHistory history;
        history.push({.covariance_O = toldBy(2.0 * kTurn, 2.0 * kShift)});
        const TrackedTool stylus{.name = kTool, .role = ToolRole::Stylus, .history = &history};
        FitInputs inputs{.tool = kTool, .stylus = stylus, .at = "2004-03-27T10:15:00Z"};
        const Vec3 p_SQ = someTip().p_SQ;
        const auto fitted = withFit(touchedSite(), inputs);
        QVERIFY(fitted.has_value());
        QVERIFY(agree(fitted->registration->fle, errorOfTip(2.0 * kTurn, 2.0 * kShift, p_SQ)));
        Site noted = touchedSite();
        for (TouchedPoint& touch : noted.touched)
            touch.seenError = 3e-3;
        QVERIFY(agree(withFit(noted, inputs)->registration->fle, 3e-3));
        inputs.stylus.reset();
        QVERIFY(withFit(touchedSite(), inputs)->registration->fle < 1e-3); // of its residuals
    }

    /// A moved manikin that is touched from farther away is not known as well as before: the middle
    /// of three places is off by at least the mean of three errors.
    void isThatOfTheTouchesOfAMovedManikinToo()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        QVERIFY(agree(model->site().registration->fle, kLeastFle.si));
        model->touching().beginRelay();
        site.m_covariance_S = toldBy(2.0 * kTurn, 2.0 * kShift);
        const RigidTransform X_TA =
            RigidTransform{rotationFromVector({0.05, -0.3, 0.1}), {0.04, -0.02, 0.03}} * site.X_TA;
        Vec3 middle_A = Vec3::Zero();
        for (const std::size_t i : {0U, 2U, 7U}) {
            model->touching().choose(i);
            site.hold(*model, X_TA * site.landmarks()[i].p_AQ);
            middle_A += site.landmarks()[i].p_AQ / 3.0;
        }
        const SiteRegistration& laid = *model->site().registration;
        QVERIFY2(laid.relays.size() == 1, qPrintable(model->problem()));
        const double one = errorOfTip(2.0 * kTurn, 2.0 * kShift, site.p_SQ);
        const double rms = std::sqrt(pointCovariance(laid.covariance_A, middle_A).trace());
        constexpr double kFirstTouches = 0.01; // they are off by far less
        QVERIFY(rms >= one / std::sqrt(3.0) * (1.0 - kAgree));
        QVERIFY(rms <= one / std::sqrt(3.0) * (1.0 + kFirstTouches));
    }
};

CARINA_TEST(TestSiteFit)

} // namespace carina::site_fit_test

#include "tst_site_fit.moc"
