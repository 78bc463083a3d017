#include "engine/geometry/rotation.h"
#include "engine/vision/camera_tracker.h"
#include "evaluation/vision/marker_renderer.h"
#include "evaluation/vision/video_writer.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <atomic>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace carina::camera_tracker_test
{
namespace
{

constexpr double kLengthTolerance = 2e-3; ///< metres
constexpr int kPictures = 5;
constexpr int kRate = 10;
constexpr Duration kPeriod = std::chrono::milliseconds{1000 / kRate};
const SessionTime kBegin{std::chrono::seconds{100}};

/// A session clock that stands still until it is set forward.
class StoppedClock
{
public:
    [[nodiscard]] ReadSessionClock reader()
    {
        return [this]() -> std::optional<SessionTime> {
            ++m_reads;
            if (m_now == 0)
                return std::nullopt;
            return SessionTime{Duration{m_now}};
        };
    }
    void set(SessionTime now) { m_now = now.time_since_epoch().count(); }

    /// How often it was read.
    [[nodiscard]] int reads() const { return m_reads; }

private:
    std::atomic<std::int64_t> m_now{0};
    std::atomic<int> m_reads{0};
};

RigidTransform tubeAt(int picture)
{
    return vision_test::facing({-0.05 + 0.02 * picture, 0.02, -0.4}, 80.0, 0.0, 40.0);
}

/// A folder with a tube that moves to the right, and is not there in picture `without`.
void renderInto(const QTemporaryDir& folder, int without = -1)
{
    const MarkerBody& body = vision_test::printed("Tube").body;
    MarkerRenderer renderer{vision_test::webcam(), kPrintedDictionary, {.samples = 2}};
    for (int i = 0; i < kPictures; ++i) {
        std::vector<PosedBody> placed;
        if (i != without)
            placed.push_back({&body, tubeAt(i)});
        QVERIFY(writePicture(folder.filePath(QStringLiteral("%1.png").arg(i)).toStdString(),
                             renderer.draw(placed)));
    }
}

CameraTrackerSettings settingsFor(const QTemporaryDir& folder)
{
    return {.place = {.kind = PicturePlace::Kind::Folder,
                      .path = folder.path().toStdString(),
                      .rate = kRate},
            .camera = vision_test::webcam(),
            .dictionary = kPrintedDictionary,
            .tools = {{"Tube", ToolRole::Tube, vision_test::printed("Tube").body}}};
}

} // namespace

class TestCameraTracker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void playsAtItsOwnSpeed()
    {
        const QTemporaryDir folder;
        renderInto(folder);
        StoppedClock clock;
        auto tracker = CameraTracker::make(settingsFor(folder), clock.reader());
        QVERIFY(tracker);
        const TrackedTool tool = (*tracker)->tools()[0];
        QCOMPARE(tool.name, std::string{"Tube"});
        QVERIFY((*tracker)->start());
        for (int i = 0; i < kPictures; ++i) {
            clock.set(kBegin + i * kPeriod);
            QTRY_COMPARE(tool.history->samples().size(), std::size_t(i) + 1);
            const PoseSample sample = *tool.history->newest();
            QCOMPARE(sample.time, kBegin + i * kPeriod);
            QCOMPARE(sample.validity, Validity::Tracked);
            QVERIFY((sample.X_FO.translation() - tubeAt(i).translation()).norm()
                    < kLengthTolerance);
        }
        clock.set(kBegin + kPictures * kPeriod);
        QTRY_VERIFY((*tracker)->trouble().find("end") != std::string::npos);
    }

    void keepsTheLastPoseOfAToolThatIsNotSeen()
    {
        const QTemporaryDir folder;
        renderInto(folder, 2);
        StoppedClock clock;
        auto tracker = CameraTracker::make(settingsFor(folder), clock.reader());
        const TrackedTool tool = (*tracker)->tools()[0];
        QVERIFY((*tracker)->start());
        for (int i = 0; i <= 2; ++i) {
            clock.set(kBegin + i * kPeriod);
            QTRY_COMPARE(tool.history->samples().size(), std::size_t(i) + 1);
        }
        const PoseSample lost = *tool.history->newest();
        QCOMPARE(lost.validity, Validity::Lost);
        QVERIFY((lost.X_FO.translation() - tubeAt(1).translation()).norm() < kLengthTolerance);
    }

    void hasNoPoseOfAToolThatWasNeverSeen()
    {
        const QTemporaryDir folder;
        renderInto(folder, 0);
        StoppedClock clock;
        auto tracker = CameraTracker::make(settingsFor(folder), clock.reader());
        const TrackedTool tool = (*tracker)->tools()[0];
        QVERIFY((*tracker)->start());
        clock.set(kBegin);
        const int before = clock.reads();
        QTRY_VERIFY(clock.reads() >= before + 3); // it waits for the time of the second picture
        QVERIFY(tool.history->samples().empty());
        clock.set(kBegin + kPeriod);
        QTRY_COMPARE(tool.history->samples().size(), std::size_t{1});
        QCOMPARE(tool.history->newest()->validity, Validity::Tracked);
    }

    void leavesOutPicturesWhoseTimeHasPassed()
    {
        const QTemporaryDir folder;
        renderInto(folder);
        StoppedClock clock;
        auto tracker = CameraTracker::make(settingsFor(folder), clock.reader());
        const TrackedTool tool = (*tracker)->tools()[0];
        QVERIFY((*tracker)->start());
        clock.set(kBegin);
        QTRY_COMPARE(tool.history->samples().size(), std::size_t{1});
        clock.set(kBegin + 4 * kPeriod);
        QTRY_VERIFY(tool.history->newest()->time == kBegin + 4 * kPeriod);
        QCOMPARE(tool.history->samples().size(), std::size_t{3}); // pictures 0, 3 and 4
    }

    void beginsAgainWhereItIsLooped()
    {
        const QTemporaryDir folder;
        renderInto(folder);
        StoppedClock clock;
        CameraTrackerSettings settings = settingsFor(folder);
        settings.playing = Playing::Looped;
        auto tracker = CameraTracker::make(settings, clock.reader());
        const TrackedTool tool = (*tracker)->tools()[0];
        QVERIFY((*tracker)->start());
        clock.set(kBegin);
        QTRY_COMPARE(tool.history->samples().size(), std::size_t{1});
        QVERIFY((*tracker)->playedSince() == kBegin);
        clock.set(kBegin + 60 * kPeriod);
        // The end is passed, and the first picture shown again at the time there is.
        QTRY_VERIFY(tool.history->newest()->time == kBegin + 60 * kPeriod);
        QVERIFY((tool.history->newest()->X_FO.translation() - tubeAt(0).translation()).norm()
                < kLengthTolerance);
        QVERIFY((*tracker)->playedSince() == kBegin + 60 * kPeriod);
    }

    void saysThatThePicturesAreOfAnotherCamera()
    {
        const QTemporaryDir folder;
        renderInto(folder);
        StoppedClock clock;
        clock.set(kBegin);
        CameraTrackerSettings settings = settingsFor(folder);
        settings.camera.width = 1280;
        auto tracker = CameraTracker::make(settings, clock.reader());
        QVERIFY((*tracker)->start());
        QTRY_VERIFY((*tracker)->trouble().find("640 x 480") != std::string::npos);
        QVERIFY((*tracker)->tools()[0].history->samples().empty());
    }

    /// A video that is a pipe: whoever reads it waits for as long as nothing is written.
    void endsWhileItsSourceKeepsItWaiting()
    {
        const QTemporaryDir folder;
        const QByteArray pipe = folder.filePath(QStringLiteral("video.avi")).toLocal8Bit();
        QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
        StoppedClock clock;
        clock.set(kBegin);
        CameraTrackerSettings settings = settingsFor(folder);
        settings.place = {.kind = PicturePlace::Kind::Video, .path = pipe.toStdString()};
        auto tracker = CameraTracker::make(settings, clock.reader());
        QVERIFY((*tracker)->start());
        int writer = -1; // can be opened as soon as there is a reader
        QTRY_VERIFY(writer >= 0 || (writer = open(pipe.constData(), O_WRONLY | O_NONBLOCK)) >= 0);
        (*tracker)->stop();
        tracker->reset();
        QCOMPARE(close(writer), 0); // only now may it read the end
    }

    void startsWithoutItsVideoAndSaysSo()
    {
        StoppedClock clock;
        CameraTrackerSettings settings{
            .place = {.kind = PicturePlace::Kind::Camera, .path = "/dev/no-such-camera"},
            .camera = vision_test::webcam(),
            .tools = {}};
        auto tracker = CameraTracker::make(settings, clock.reader());
        QVERIFY((*tracker)->start());
        QVERIFY((*tracker)->start()); // no effect
        QTRY_VERIFY((*tracker)->trouble().find("/dev/no-such-camera") != std::string::npos);
        (*tracker)->stop();
    }

    void refusesWhatCannotBeTracked()
    {
        CameraTrackerSettings settings{.camera = vision_test::webcam()};
        settings.tools = {{"Nose", ToolRole::Other, {}}};
        const auto empty = CameraTracker::make(settings, {});
        QVERIFY(!empty);
        QCOMPARE(empty.error().code, Errc::OutOfRange);
        QVERIFY(empty.error().detail.find("Nose") != std::string::npos);
        settings.tools.clear();
        settings.camera.focal.x() = 0.0;
        QVERIFY(!CameraTracker::make(settings, {}));
    }
};

CARINA_TEST(TestCameraTracker)

} // namespace carina::camera_tracker_test

#include "tst_camera_tracker.moc"
