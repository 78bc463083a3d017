#include "tests/engine/registration/landmarks/touching_person.h"
#include "tests/support/test_class.h"

#include <array>
#include <limits>
#include <set>

namespace carina::touch_recognition_test
{

using namespace test;

class TestTouchRecognition : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesWhatWasAskedForWhereDistancesAllowIt()
    {
        Person person{229};
        person.noise = 0.0;
        person.begin();
        QVERIFY(person.recognise(0, 0).verdict == TouchVerdict::Landmark);
        QCOMPARE(person.recognise(0, {}).candidates.size(), kCount); // nothing is known yet
        person.take(0);
        // The notch is as far from the xiphoid process as from the fifth ribs, to 3 mm.
        for (const std::size_t asked : {1U, 2U, 3U}) {
            const TouchFinding finding = person.recognise(2, asked);
            QVERIFY(finding.verdict == TouchVerdict::Landmark);
            QCOMPARE(finding.landmark, asked);
            QVERIFY(!finding.distance);
        }
        const TouchFinding jaw = person.recognise(4, 1); // not as far as what was asked for
        QVERIFY(jaw.verdict == TouchVerdict::Ambiguous);
        QVERIFY((std::set<std::size_t>{jaw.candidates.begin(), jaw.candidates.end()}
                 == std::set<std::size_t>{4, 5}));
        person.take(4);
        const TouchFinding rib = person.recognise(6, 1);
        QVERIFY(rib.verdict
                == TouchVerdict::Landmark); // two not in the middle know left from right
        QCOMPARE(rib.landmark, 6U);
    }

    void knowsALandmarkTouchedAgain_data()
    {
        QTest::addColumn<std::vector<std::size_t>>("before");
        QTest::addColumn<Vec3>("wrong"); // m, of the first touch of landmark 4
        const Vec3 none = Vec3::Zero();
        QTest::newRow("alone") << std::vector<std::size_t>{4} << none;
        QTest::newRow("one of two") << std::vector<std::size_t>{0, 4} << none;
        QTest::newRow("one of five") << std::vector<std::size_t>{0, 2, 4, 5, 7} << none;
        QTest::newRow("at a wrong place before")
            << std::vector<std::size_t>{0, 1, 2, 4, 7} << Vec3{0.0, -0.03, 0.02};
    }

    void knowsALandmarkTouchedAgain()
    {
        QFETCH(std::vector<std::size_t>, before);
        QFETCH(Vec3, wrong);
        Person person{233};
        for (int trial = 0; trial < 100; ++trial) {
            person.begin();
            for (const std::size_t landmark : before)
                person.take(landmark);
            *person.touches[4] += person.X_TA.rotation() * wrong;
            const TouchFinding finding = person.recognise(4, person.firstOpen());
            if (finding.verdict == TouchVerdict::Nowhere)
                continue; // one in a thousand
            QVERIFY(finding.verdict == TouchVerdict::Again);
            QCOMPARE(finding.landmark, 4U);
        }
    }

    /// On a manikin 4 % larger than the anatomy the last landmarks lie up to 10 mm from where the
    /// others put them; the touches say why.
    void knowsTheLandmarksOfALargerManikin()
    {
        Person person{241};
        int known = 0;
        for (int trial = 0; trial < 100; ++trial) {
            person.begin();
            for (std::size_t landmark = 0; landmark < kCount; ++landmark) {
                const Vec3 p_TQ =
                    person.X_TA * Vec3{1.04 * person.p_A[landmark] + 5e-4 * person.hand.unit()};
                const auto finding =
                    recogniseTouch({person.p_A, person.touches}, p_TQ, kFle, landmark);
                known += finding->verdict == TouchVerdict::Landmark && finding->landmark == landmark
                             ? 1
                             : 0;
                person.touches[landmark] = p_TQ;
            }
        }
        qInfo("%d of 800 recognised", known);
        QVERIFY(known > 680);
    }

    void knowsAPlaceThatIsNoLandmark()
    {
        Person person{239};
        person.begin();
        for (std::size_t landmark = 0; landmark < 6; ++landmark)
            person.touches[landmark] = person.X_TA * person.p_A[landmark];
        const Vec3 beside{0.0, -0.03, 0.0};
        const Vec3 p_TQ = person.X_TA * (person.p_A[6] + beside);
        const auto finding = recogniseTouch({person.p_A, person.touches}, p_TQ, kFle);
        QVERIFY(finding->verdict == TouchVerdict::Nowhere);
        QCOMPARE(finding->landmark, 6U);
        QVERIFY(std::abs(finding->distance->si - 0.03) < 1e-9);
        QVERIFY(finding->candidates.empty());
    }

    /// Two places as far from the touch: neither is a thousand times as likely.
    void doesNotChooseBetweenNeighbours()
    {
        Person person{241};
        person.begin();
        person.p_A.push_back(person.p_A[6] + Vec3{0.004, 0.0, 0.0});
        person.touches.emplace_back();
        for (std::size_t landmark = 0; landmark < 6; ++landmark)
            person.touches[landmark] = person.X_TA * person.p_A[landmark];
        const Vec3 p_TQ = person.X_TA * (person.p_A[6] + Vec3{0.0015, 0.0, 0.0});
        const auto finding = recogniseTouch({person.p_A, person.touches}, p_TQ, kFle);
        QVERIFY(finding->verdict == TouchVerdict::Ambiguous);
        QCOMPARE(finding->candidates, (std::vector<std::size_t>{6, 8}));
        QCOMPARE(finding->landmark, 6U);
    }

    void namesAllAnewWhereThatExplainsThem()
    {
        Person person{251};
        person.begin();
        const std::array<std::size_t, 8> named{1, 0, 8, 8, 5, 8, 8, 8}; // 8: not touched
        for (std::size_t landmark = 0; landmark < kCount; ++landmark) {
            if (named[landmark] < kCount)
                person.touches[landmark] = person.X_TA * person.p_A[named[landmark]];
        }
        const Vec3 p_TQ = person.X_TA * person.p_A[6];
        const auto finding = recogniseTouch({person.p_A, person.touches}, p_TQ, kFle, 2);
        QVERIFY(finding->verdict == TouchVerdict::Renamed);
        QCOMPARE(finding->landmark, 6U);
        for (std::size_t landmark = 0; landmark < kCount; ++landmark) {
            const auto& touch = finding->renamed_p_TQ[landmark];
            const bool touched = landmark == 0 || landmark == 1 || landmark == 5 || landmark == 6;
            QCOMPARE(touch.has_value(), touched);
            if (touched)
                QVERIFY((*touch - person.X_TA * person.p_A[landmark]).norm() < 1e-9);
        }
    }

    void refusesWhatIsNoPoint()
    {
        Person person{257};
        person.begin();
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const auto code = [&](const Vec3& p_TQ) {
            return recogniseTouch({person.p_A, person.touches}, p_TQ, kFle).error().code;
        };
        QCOMPARE(code({0.0, nan, 0.0}), Errc::NotFinite);
        QCOMPARE(code({0.0, 0.0, 2e3}), Errc::OutOfRange);
        person.touches[3] = Vec3{nan, 0.0, 0.0};
        QCOMPARE(code(Vec3::Zero()), Errc::NotFinite);
        person.p_A.resize(2);
        person.touches.resize(2);
        QCOMPARE(code(Vec3::Zero()), Errc::TooFewLandmarks);
    }
};

CARINA_TEST(TestTouchRecognition)

} // namespace carina::touch_recognition_test

#include "tst_touch_recognition.moc"
