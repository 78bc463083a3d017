#include "engine/registration/calibration/pivot_collector.h"
#include "engine/tracking/sequence_file.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

namespace carina::recorded_pivots_test
{
namespace
{

const Vec3 kTip_S{108.565e-3, 7.77385e-3, 2.5389e-3}; ///< as the configuration beside it says
constexpr double kSameDivot = 3e-3;                   // metres
constexpr std::size_t kFewest = 60;                   // poses, 4 s
constexpr double kScatter = 1.3e-3;                   // metres, of the tips about their mean
constexpr double kApart = 3e-3;                       // of another calibration, metres

} // namespace

/// The recording of a stylus that touched eight divots: it was swung in each of them.
class TestRecordedPivots : public QObject
{
    Q_OBJECT

private:
    std::vector<PoseSample> m_samples; ///< X_RS in the frame of the reference

    /// What was recorded with the tip in one place, one after the other.
    std::vector<std::vector<RigidTransform>> touches() const
    {
        std::vector<std::vector<RigidTransform>> all(1);
        for (const PoseSample& sample : m_samples) {
            const Vec3 p_RQ = sample.X_FO * kTip_S;
            if (!all.back().empty() && (all.back().front() * kTip_S - p_RQ).norm() > kSameDivot)
                all.emplace_back();
            all.back().push_back(sample.X_FO);
        }
        std::erase_if(all, [](const auto& poses) { return poses.size() < kFewest; });
        return all;
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto path = test::testData(test::kEightDivots);
        if (!path)
            return;
        const auto sequence = readSequenceFile(*path);
        QVERIFY(sequence.has_value());
        const auto samplesOf = [&](const char* name) {
            return std::ranges::find(sequence->tools, name, &RecordedTool::name)->samples;
        };
        const auto stylus = samplesOf("Stylus");
        const auto reference = samplesOf("Reference");
        for (std::size_t i = 0; i < stylus.size(); ++i) {
            m_samples.push_back(stylus[i]);
            m_samples.back().X_FO = reference[i].X_FO.inverse() * stylus[i].X_FO;
        }
    }

    void init()
    {
        if (!test::testData(test::kEightDivots))
            QSKIP("tracker/eight-landmarks is not there");
    }

    void findsTheSameTipInEveryDivot()
    {
        std::vector<Vec3> tips;
        double least = 1.0; // RMS, metres
        double most = 0.0;
        for (const auto& X_RS : touches()) {
            const auto pivot = calibratePivot(X_RS);
            QVERIFY2(pivot.has_value(), pivot ? "" : pivot.error().detail.c_str());
            QVERIFY(pivot->rms < 0.8e-3);
            QVERIFY(pivot->outliers < 10);
            tips.push_back(pivot->p_SQ);
            least = std::min(least, pivot->rms);
            most = std::max(most, pivot->rms);
        }
        QVERIFY2(tips.size() >= 7, qPrintable(QString::number(tips.size())));
        Vec3 mean = Vec3::Zero();
        for (const Vec3& tip : tips)
            mean += tip / double(tips.size());
        double scatter = 0.0;
        for (const Vec3& tip : tips)
            scatter = std::max(scatter, (tip - mean).norm());
        qInfo("%d divots: RMS %.2f to %.2f mm, tips up to %.2f mm from their mean",
              int(tips.size()), least * 1e3, most * 1e3, scatter * 1e3);
        QVERIFY(scatter < kScatter);
        QVERIFY((mean - kTip_S).norm() < kApart);
    }

    /// Nobody says when the stylus is in a divot, nor when it goes to the next.
    void collectsByItself()
    {
        PivotCollector collector{{.certainty = millimetres(0.3)}};
        int swings = 0;
        std::optional<PivotCalibration> pivot;
        PivotStage before = PivotStage::Waiting;
        for (const PoseSample& sample : m_samples) {
            const auto done = collector.push(sample.time, sample.X_FO, sample.validity);
            if (done && !pivot)
                pivot = done;
            if (done)
                collector.restart();
            const PivotStage stage = collector.progress().stage;
            swings += before == PivotStage::Waiting && stage == PivotStage::Swinging ? 1 : 0;
            before = stage;
        }
        QVERIFY(pivot.has_value());
        QVERIFY((pivot->p_SQ - kTip_S).norm() < kApart);
        QVERIFY(pivot->rms < 0.8e-3);
        QVERIFY2(swings >= 8, qPrintable(QString::number(swings)));
    }
};

CARINA_TEST(TestRecordedPivots)

} // namespace carina::recorded_pivots_test

#include "tst_recorded_pivots.moc"
