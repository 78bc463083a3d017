#include "engine/registration/watch/re_registration.h"

#include "engine/geometry/rotation.h"
#include "engine/registration/error/target_error.h"
#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::re_registration_test
{
namespace
{

constexpr int kTrials = 20'000;
constexpr double kShare = 0.05; // of the predicted error

using Which = std::vector<std::size_t>;

const Which kNotchRibAndJaw{0, 2, 5};
const Which kRibJawAndOtherEnd{2, 5, 7}; // a wide triangle
const Which kAllEight{0, 1, 2, 3, 4, 5, 6, 7};

Vec3 stray(test::Hand& hand, Length fle) { return fle.si / std::sqrt(3.0) * hand.unit(); }

/// A manikin that is registered, moved, and touched again; fitted by other code.
struct MovedManikin {
    EarlierRegistration earlier;
    std::vector<Retouch> touches;
    RigidTransform X_AM; ///< truly
    RigidTransform X_TM;
    std::vector<Vec3> p_AQ;
    std::vector<Vec3> p_MQ;

    MovedManikin(test::Hand& hand, const Which& which, const TouchErrors& errors)
        : X_AM{hand.pose()}, X_TM{hand.pose()}, p_AQ{test::firstLandmarks(8)}
    {
        std::vector<Vec3> spot;
        for (const Vec3& p : p_AQ) {
            spot.push_back(X_AM.inverse() * (p + stray(hand, errors.place)));
            p_MQ.push_back(spot.back() + stray(hand, errors.first));
        }
        earlier.X_AM = test::hornFit(p_AQ, p_MQ);
        for (std::size_t i = 0; i < p_AQ.size(); ++i)
            earlier.landmarks.push_back({"landmark " + std::to_string(i), p_AQ[i], p_MQ[i]});
        for (const std::size_t i : which)
            touches.push_back({i, X_TM * (spot[i] + stray(hand, errors.again))});
    }

    [[nodiscard]] RigidTransform fitted() const
    {
        std::vector<Vec3> now;
        std::vector<Vec3> then;
        for (const Retouch& touch : touches) {
            now.push_back(touch.p_TQ);
            then.push_back(p_MQ[touch.landmark]);
        }
        return earlier.X_AM * test::hornFit(now, then).inverse();
    }
};

constexpr TouchErrors kExact{millimetres(1e-9), millimetres(1e-9)};
constexpr TouchErrors kHand{millimetres(1.0), millimetres(1.0)};

double farthest(const RigidTransform& a, const RigidTransform& b)
{
    double far = 0.0;
    for (const Vec3& p : test::kTargets)
        far = std::max(far, (a * p - b * p).norm());
    return far;
}

} // namespace

class TestReRegistration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsAManikinThatWasMoved()
    {
        test::Hand hand{301};
        for (int trial = 0; trial < 100; ++trial) {
            const MovedManikin moved{hand, kNotchRibAndJaw, kExact};
            const auto again = reRegister(moved.earlier, moved.touches, kHand);
            QVERIFY(again.has_value());
            constexpr double kRounding = 1e-7; // m
            QVERIFY(farthest(again->X_TM, moved.X_TM) < kRounding);
            QVERIFY(farthest(again->X_AT * moved.X_TM, moved.X_AM) < kRounding);
            QVERIFY(again->rms < kRounding);
            QCOMPARE(again->residuals.size(), 3U);
            QCOMPARE(again->explanations, 1U);
        }
    }

    void fitsToWhatWasTouchedBefore()
    {
        test::Hand hand{307};
        for (int trial = 0; trial < 100; ++trial) {
            const MovedManikin moved{hand, {0, 2, 5, 6}, kHand};
            const auto again = reRegister(moved.earlier, moved.touches, kHand);
            QVERIFY(again.has_value());
            QVERIFY(farthest(again->X_AT * moved.X_TM, moved.fitted() * moved.X_TM) < 1e-9);
            double squares = 0.0;
            for (std::size_t j = 0; j < 4; ++j) {
                const Vec3 d_T =
                    moved.touches[j].p_TQ - again->X_TM * moved.p_MQ[moved.touches[j].landmark];
                QVERIFY(std::abs(again->residuals[j] - d_T.norm()) < 1e-12);
                squares += d_T.squaredNorm();
            }
            QVERIFY(std::abs(again->rms - std::sqrt(squares / 4.0)) < 1e-12);
        }
    }

    void predictsItsError_data()
    {
        QTest::addColumn<Which>("which");
        QTest::addColumn<TouchErrors>("errors");
        QTest::newRow("three") << kRibJawAndOtherEnd << kHand;
        QTest::newRow("three, nearly on one line") << kNotchRibAndJaw << kHand;
        QTest::newRow("four, more carefully")
            << Which{0, 1, 4, 7} << TouchErrors{millimetres(1.0), millimetres(0.5)};
        QTest::newRow("five, wrong places")
            << Which{0, 2, 3, 4, 5}
            << TouchErrors{millimetres(0.5), millimetres(0.5), millimetres(1.0)};
        QTest::newRow("all") << kAllEight << kHand;
    }

    void predictsItsError()
    {
        QFETCH(Which, which);
        QFETCH(TouchErrors, errors);
        test::Hand hand{311};
        std::array<double, test::kTargets.size()> squares{};
        for (int trial = 0; trial < kTrials; ++trial) {
            const MovedManikin moved{hand, which, errors};
            const RigidTransform off = moved.fitted() * moved.X_TM * moved.X_AM.inverse();
            for (std::size_t t = 0; t < squares.size(); ++t)
                squares[t] += (off * test::kTargets[t] - test::kTargets[t]).squaredNorm() / kTrials;
        }
        const MovedManikin moved{hand, which, kExact};
        const auto again = reRegister(moved.earlier, moved.touches, errors);
        for (std::size_t t = 0; t < squares.size(); ++t) {
            const double predicted = targetError(again->covariance_A, test::kTargets[t]).rms.si;
            const double found = std::sqrt(squares[t]);
            qInfo("%s: predicted %.3f mm, found %.3f mm", test::kTargetNames[t], 1e3 * predicted,
                  1e3 * found);
            QVERIFY(std::abs(found / predicted - 1.0) < kShare);
        }
    }

    /// A registration that was refined on a surface has an error that no touch tells of.
    void addsToTheErrorOfARefinedRegistration()
    {
        test::Hand hand{331};
        const Mat6 refined_A =
            0.5 * *fitCovariance(equalErrors(test::firstLandmarks(8), kHand.first));
        const Mat6 factor = refined_A.llt().matrixL();
        std::array<double, test::kTargets.size()> squares{};
        for (int trial = 0; trial < kTrials; ++trial) {
            MovedManikin moved{hand, kRibJawAndOtherEnd, kHand};
            Eigen::Matrix<double, 6, 1> motion;
            motion << hand.unit(), hand.unit();
            motion = factor * motion;
            const RigidTransform off_A{rotationFromVector(motion.head<3>()), motion.tail<3>()};
            moved.earlier.X_AM = off_A * moved.X_AM;
            const RigidTransform off = moved.fitted() * moved.X_TM * moved.X_AM.inverse();
            for (std::size_t t = 0; t < squares.size(); ++t)
                squares[t] += (off * test::kTargets[t] - test::kTargets[t]).squaredNorm() / kTrials;
        }
        MovedManikin moved{hand, kRibJawAndOtherEnd, kExact};
        moved.earlier.covariance_A = refined_A;
        const auto again = reRegister(moved.earlier, moved.touches, kHand);
        for (std::size_t t = 0; t < squares.size(); ++t) {
            const double predicted = targetError(again->covariance_A, test::kTargets[t]).rms.si;
            QVERIFY(std::abs(std::sqrt(squares[t]) / predicted - 1.0) < kShare);
        }
    }

    /// The errors of the first touches cancel: it is a registration of its own.
    void isANewRegistrationWhereAllAreTouched()
    {
        test::Hand hand{313};
        const MovedManikin moved{hand, kAllEight, kExact};
        const auto again =
            reRegister(moved.earlier, moved.touches, {millimetres(3.0), millimetres(1.0)});
        const auto alone = fitCovariance(equalErrors(moved.p_AQ, millimetres(1.0)));
        QVERIFY((again->covariance_A - *alone).norm() < 1e-9 * alone->norm());
    }

    void saysWhatIsWrong_data()
    {
        QTest::addColumn<Which>("which");
        QTest::addColumn<Vec3>("beside"); // m, of the second touch
        QTest::addColumn<Which>("order"); // the touch at each
        QTest::addColumn<QByteArray>("word");
        const Vec3 none = Vec3::Zero();
        const Which same{0, 1, 2, 3, 4};
        QTest::newRow("two") << Which{0, 2} << none << Which{0, 1} << QByteArray{"3 are"};
        QTest::newRow("beside, of three") << Which{0, 2, 5} << Vec3{0.02, -0.02, -0.02}
                                          << Which{0, 1, 2} << QByteArray{"landmark 2"};
        QTest::newRow("beside, of five")
            << Which{0, 2, 5, 6, 7} << Vec3{0.0, 0.02, -0.01} << same << QByteArray{"landmark 2"};
        QTest::newRow("exchanged, of three") << Which{0, 2, 5} << none << Which{1, 0, 2}
                                             << QByteArray{"\"landmark 0\", \"landmark 2\" were"};
        QTest::newRow("exchanged, of five") << Which{0, 2, 3, 5, 7} << none << Which{0, 2, 1, 3, 4}
                                            << QByteArray{"\"landmark 2\", \"landmark 3\" were"};
    }

    void saysWhatIsWrong()
    {
        QFETCH(Which, which);
        QFETCH(Vec3, beside);
        QFETCH(Which, order);
        QFETCH(QByteArray, word);
        test::Hand hand{317};
        for (int trial = 0; trial < 20; ++trial) {
            const MovedManikin moved{hand, which, {millimetres(0.3), millimetres(0.3)}};
            std::vector<Retouch> touches = moved.touches;
            for (std::size_t i = 0; i < touches.size(); ++i)
                touches[i].p_TQ = moved.touches[order[i]].p_TQ;
            touches[1].p_TQ += moved.X_TM.rotation() * (moved.X_AM.rotation().conjugate() * beside);
            const auto again = reRegister(moved.earlier, touches, kHand);
            QVERIFY(!again);
            const QByteArray detail = QByteArray::fromStdString(again.error().detail);
            QVERIFY2(detail.contains(word), detail.constData());
        }
    }

    void refusesTouchesOnOneLine()
    {
        test::Hand hand{331};
        MovedManikin moved{hand, {0, 1, 2}, kExact};
        for (std::size_t i = 0; i < 3; ++i) {
            moved.earlier.landmarks[i].p_MQ = {0.1 * double(i), 0.0, 0.0};
            moved.touches[i].p_TQ = {0.0, 0.1 * double(i), 0.3};
        }
        const auto again = reRegister(moved.earlier, moved.touches, kHand);
        QVERIFY(!again);
        QCOMPARE(again.error().code, Errc::DegenerateLandmarks);
        QVERIFY(again.error().detail.find("on one line") != std::string::npos);
        moved.touches[0].p_TQ.x() = std::numeric_limits<double>::infinity();
        QCOMPARE(reRegister(moved.earlier, moved.touches, kHand).error().code, Errc::NotFinite);
    }

    /// Sternal notch and both fifth ribs: turned over, left for right, they fit as well.
    void countsWhatElseWouldFit()
    {
        test::Hand hand{337};
        const MovedManikin moved{hand, {0, 2, 3}, kExact};
        QCOMPARE(reRegister(moved.earlier, moved.touches, kHand)->explanations, 2U);
    }
};

CARINA_TEST(TestReRegistration)

} // namespace carina::re_registration_test

#include "tst_re_registration.moc"
