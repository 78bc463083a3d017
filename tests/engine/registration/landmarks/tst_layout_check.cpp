#include "engine/registration/landmarks/layout_check.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <limits>

namespace carina::layout_check_test
{
namespace
{

constexpr Length kFle = millimetres(1.0);

std::vector<LandmarkError> first(int count)
{
    return equalErrors(test::firstLandmarks(count), kFle);
}

std::vector<LandmarkError> someCandidates()
{
    return equalErrors(
        std::vector<Vec3>{
            {0.0, -0.1, 0.15}, {0.0, -0.06, 0.03}, {0.05, -0.12, -0.15}, {0.0, -0.13, -0.05}},
        kFle);
}

} // namespace

class TestLayoutCheck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Rib-cage points alone are worst where intubation happens.
    void findsTheWorstTarget()
    {
        const auto report = checkLayout(first(4), test::kTargets, millimetres(1.0));
        QVERIFY(report.has_value());
        QCOMPARE(report->targets.size(), test::kTargets.size());
        QCOMPARE(test::kTargetNames[report->worst], "incisors");
        const auto covariance = fitCovariance(first(4));
        for (std::size_t t = 0; t < test::kTargets.size(); ++t) {
            QCOMPARE(report->targets[t].rms, targetError(*covariance, test::kTargets[t]).rms);
            QVERIFY(report->targets[t].rms <= report->targets[report->worst].rms);
        }
    }

    void warnsAboveTheLimit()
    {
        const auto open = checkLayout(first(4), test::kTargets, millimetres(0.0));
        const Length worst = open->targets[open->worst].rms;
        QVERIFY(!open->withinLimit);
        QVERIFY(checkLayout(first(4), test::kTargets, worst)->withinLimit);
        QVERIFY(!checkLayout(first(4), test::kTargets, 0.999 * worst)->withinLimit);
    }

    /// A sternum and two ribs hardly beside it: the turn about the sternum throws the jaw aside.
    void warnsOfALayoutNearALine()
    {
        std::vector<Vec3> narrow = test::firstLandmarks(4);
        narrow[2].x() = 0.008;
        narrow[3].x() = -0.008;
        for (std::size_t i : {2U, 3U})
            narrow[i].y() = -0.126;
        const auto wide = checkLayout(first(4), test::kTargets, millimetres(2.0));
        const auto report =
            checkLayout(equalErrors(narrow, kFle), test::kTargets, millimetres(2.0));
        QVERIFY(report.has_value());
        QVERIFY(wide->withinLimit);
        QVERIFY(!report->withinLimit);
        QCOMPARE(report->targets[report->worst].weakestAxis, BodyAxis::LeftRight);
    }

    void weighsAsTold()
    {
        auto landmarks = first(8);
        const auto errors = test::unlikeErrors(landmarks.size());
        for (std::size_t i = 0; i < landmarks.size(); ++i)
            landmarks[i].covariance_A = errors[i];
        const auto alike = checkLayout(landmarks, test::kTargets, kFle);
        const auto weighed = checkLayout(landmarks, test::kTargets, kFle, Weighting::ByCovariance);
        for (std::size_t t = 0; t < test::kTargets.size(); ++t)
            QVERIFY(weighed->targets[t].rms < alike->targets[t].rms); // Gauss and Markov
    }

    /// The one with which the worst target is best, as trying all shows.
    void findsWhereOneMoreHelpsMost()
    {
        const auto next = nextLandmark(first(4), someCandidates(), test::kTargets);
        QVERIFY(next.has_value() && next->has_value());
        QCOMPARE((*next)->candidate, 0U); // at the chin
        for (std::size_t i = 0; i < someCandidates().size(); ++i) {
            auto with = first(4);
            with.push_back(someCandidates()[i]);
            const auto report = checkLayout(with, test::kTargets, kFle);
            const Length worst = report->targets[report->worst].rms;
            QVERIFY((*next)->worstRms <= worst);
            if (i == (*next)->candidate)
                QCOMPARE((*next)->worstRms, worst);
        }
        auto reversed = someCandidates();
        std::reverse(reversed.begin(), reversed.end());
        QCOMPARE((*nextLandmark(first(4), reversed, test::kTargets))->candidate, 3U);
    }

    /// Weighed alike, a landmark that strays far does harm.
    void offersNothingThatDoesNotHelp()
    {
        auto candidates = someCandidates();
        candidates.resize(1);
        candidates[0].covariance_A *= 1e4;
        const auto next = nextLandmark(first(8), candidates, test::kTargets);
        QVERIFY(next.has_value());
        QVERIFY(!next->has_value());
        const auto weighed =
            nextLandmark(first(8), candidates, test::kTargets, Weighting::ByCovariance);
        QVERIFY(weighed->has_value());
        QVERIFY(!*nextLandmark(first(8), {}, test::kTargets));
    }

    void refuses()
    {
        QCOMPARE(checkLayout(first(4), {}, kFle).error().code, Errc::OutOfRange);
        QCOMPARE(checkLayout(first(2), test::kTargets, kFle).error().code, Errc::TooFewLandmarks);
        const std::vector<Vec3> nowhere{{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}};
        QCOMPARE(checkLayout(first(4), nowhere, kFle).error().code, Errc::NotFinite);
        QCOMPARE(nextLandmark(first(2), someCandidates(), test::kTargets).error().code,
                 Errc::TooFewLandmarks);
        const auto bad = equalErrors(nowhere, kFle);
        QCOMPARE(nextLandmark(first(4), bad, test::kTargets).error().code, Errc::NotFinite);
    }
};

CARINA_TEST(TestLayoutCheck)

} // namespace carina::layout_check_test

#include "tst_layout_check.moc"
