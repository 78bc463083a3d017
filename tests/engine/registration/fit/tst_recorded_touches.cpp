#include "engine/geometry/fit/rigid_fit.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QRegularExpression>

namespace carina::recorded_touches_test
{
namespace
{

/// Of plain dwell detection and a rigid fit on this recording.
constexpr double kKnownRms = 0.200e-3;
constexpr double kTolerance = 0.005e-3; // m

/// The recording by regular expression alone, millimetres as written.
std::vector<Eigen::Matrix4d> posesOf(const QString& text, const QString& tool)
{
    std::vector<Eigen::Matrix4d> poses;
    const QRegularExpression line{
        QStringLiteral("^Seq_Frame\\d+_%1ToTrackerTransform = (.*)$").arg(tool),
        QRegularExpression::MultilineOption};
    for (auto matches = line.globalMatch(text); matches.hasNext();) {
        const auto words = matches.next().captured(1).simplified().split(QLatin1Char{' '});
        Eigen::Matrix4d matrix;
        for (int i = 0; i < 16; ++i)
            matrix(i / 4, i % 4) = words[i].toDouble();
        poses.push_back(matrix);
    }
    return poses;
}

// Of the configuration beside the recording.
const Eigen::Vector4d kTip_S_mm{108.565, 7.77385, 2.5389, 1.0};
const std::vector<Vec3> kPhantom_mm{{104.3, 5.0, 20.0}, {104.3, 45.0, 20.0}, {104.3, 45.0, 0.0},
                                    {104.3, -5.0, 0.0}, {-34.3, 45.0, 15.0}, {-34.3, -5.0, 20.0},
                                    {-34.3, -5.0, 0.0}, {-34.3, 45.0, 0.0}};

} // namespace

/// Dwell detection and rigid fit on a stylus that touched eight divots of a phantom.
class TestRecordedTouches : public QObject
{
    Q_OBJECT

private:
    std::vector<DwellPoint> m_points;

private Q_SLOTS:
    void initTestCase()
    {
        const auto path = test::testData(test::kEightDivots);
        if (!path)
            return;
        QFile file{QString::fromStdString(path->string())};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromLatin1(file.readAll());
        const auto X_TR = posesOf(text, QStringLiteral("Reference"));
        const auto X_TS = posesOf(text, QStringLiteral("Stylus"));
        const QRegularExpression stamp{QStringLiteral("^Seq_Frame\\d+_Timestamp = (.*)$"),
                                       QRegularExpression::MultilineOption};
        auto stamps = stamp.globalMatch(text);
        DwellDetector detector;
        for (std::size_t i = 0; i < X_TS.size() && stamps.hasNext(); ++i) {
            const SessionTime time{fromSeconds(stamps.next().captured(1).toDouble())};
            const Vec3 p_RQ_mm = (X_TR[i].inverse() * (X_TS[i] * kTip_S_mm)).head<3>();
            if (const auto point = detector.push(time, 1e-3 * p_RQ_mm, Validity::Tracked))
                m_points.push_back(*point);
        }
    }

    void init()
    {
        if (!test::testData(test::kEightDivots))
            QSKIP("tracker/eight-landmarks is not there");
    }

    /// Eight divots, and the stylus at rest before and after.
    void findsEveryTouchOnce() { QCOMPARE(m_points.size(), 10U); }

    void fitsAsWellAsItIsKnownTo()
    {
        QVERIFY(m_points.size() >= 9U);
        std::vector<LandmarkPair> pairs;
        for (std::size_t i = 0; i < kPhantom_mm.size(); ++i)
            pairs.push_back({1e-3 * kPhantom_mm[i], m_points[i + 1].p_FQ});
        const auto fit = fitRigid(pairs);
        QVERIFY(fit.has_value());
        qInfo("rms %.4f mm", 1e3 * fit->rms);
        QVERIFY(std::abs(fit->rms - kKnownRms) < kTolerance);
    }
};

CARINA_TEST(TestRecordedTouches)

} // namespace carina::recorded_touches_test

#include "tst_recorded_touches.moc"
