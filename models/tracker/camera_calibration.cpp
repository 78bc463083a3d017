#include "models/tracker/camera_calibration.h"

#include "engine/core/ended_threads.h"
#include "engine/core/expects.h"
#include "engine/io/files/unused_name.h"
#include "engine/io/site/devices/camera_file.h"

#include <QDateTime>

#include <utility>

namespace carina
{

namespace
{

/// The file that a calibration is written to: the present one; beside one of OpenCV a new one.
std::filesystem::path calibrationToWrite(const std::filesystem::path& present)
{
    if (!isOpenCvCamera(present))
        return present;
    std::filesystem::path own = present;
    return unusedName(own.replace_extension(".json"));
}

} // namespace

std::optional<CameraToCalibrate> cameraOf(const TrackerChoice& choice)
{
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    if (described == nullptr || described->kind != TrackerKind::Camera)
        return std::nullopt;
    return CameraToCalibrate{
        QString::fromStdString(described->address),
        QString::fromStdString(calibrationToWrite(described->calibration).string()),
        {described->camera.width, described->camera.height}};
}

CameraCalibration::CameraCalibration() : m_shared{std::make_shared<Shared>()}
{
    m_shared->owner = this;
}

CameraCalibration::~CameraCalibration()
{
    {
        const std::lock_guard lock{m_shared->mutex};
        m_shared->owner = nullptr;
    }
    joinLater(std::move(m_thread));
}

void CameraCalibration::begin(const CameraToCalibrate& camera, double square_mm)
{
    m_thread.request_stop();
    const std::filesystem::path path{camera.place.toStdString()};
    const PicturePlace place{.kind = kindOfPlace(path),
                             .path = path,
                             .width = camera.size.width(),
                             .height = camera.size.height()};
    const CalibrationBoard board{.square = 1e-3 * square_mm};
    tell(*m_shared, {.state = State::Looking}, {});
    m_thread = std::jthread{[shared = m_shared, before = std::move(m_thread), place,
                             board](const std::stop_token& stopping) mutable {
        if (before.joinable())
            before.join(); // which has the camera
        look(stopping, *shared, place, board);
    }};
}

void CameraCalibration::end()
{
    {
        // Nothing is told by the thread after this.
        const std::lock_guard lock{m_shared->mutex};
        m_thread.request_stop();
    }
    Progress now = progress();
    if (now.state == State::Looking) {
        now.state = State::Ended;
        tell(*m_shared, std::move(now), {});
    }
}

void CameraCalibration::look(const std::stop_token& stopping, Shared& shared,
                             const PicturePlace& place, const CalibrationBoard& board)
{
    auto source = PictureSource::open(place);
    Progress now{.state = State::Looking};
    if (!source) {
        now.state = State::Silent;
        now.trouble = source.error().detail;
        return tell(shared, std::move(now), stopping);
    }
    BoardCalibration calibration{board};
    while (!stopping.stop_requested()) {
        const auto taken = source->next();
        if (!taken)
            break;
        if (!calibration.add(taken->picture))
            continue;
        now.coverage = calibration.coverage();
        now.fitted = calibration.fit();
        tell(shared, now, stopping);
    }
    const bool isGone = place.kind == PicturePlace::Kind::Camera;
    now.state = isGone ? State::Silent : State::Ended;
    if (isGone)
        now.trouble = place.path.string();
    tell(shared, std::move(now), stopping);
}

/// Unless the thread with this token was asked to stop.
void CameraCalibration::tell(Shared& shared, Progress progress, const std::stop_token& stopping)
{
    const std::lock_guard lock{shared.mutex};
    if (stopping.stop_requested() || shared.owner == nullptr)
        return;
    shared.progress = std::move(progress);
    QMetaObject::invokeMethod(
        shared.owner, [owner = shared.owner] { Q_EMIT owner->changed(); }, Qt::QueuedConnection);
}

CameraCalibration::Progress CameraCalibration::progress() const
{
    const std::lock_guard lock{m_shared->mutex};
    return m_shared->progress;
}

BoardCoverage CameraCalibration::coverage() const { return progress().coverage; }

bool CameraCalibration::isFitted() const
{
    const auto fitted = progress().fitted;
    return fitted && std::holds_alternative<BoardFit>(*fitted);
}

QString CameraCalibration::text() const
{
    const Progress now = progress();
    if (now.state == State::Idle)
        return {};
    if (now.state == State::Silent)
        return tr("▲ The camera gives no picture (%1): see that it is plugged in and that no other "
                  "program uses it.")
            .arg(QString::fromStdString(now.trouble));
    if (!now.fitted)
        return now.state == State::Looking
                   ? tr("Looking for the board …")
                   : tr("▲ The board was not seen: show all of it, sharp and evenly lit.");
    if (const auto* fault = std::get_if<CalibrationFault>(&*now.fitted))
        return faultText(*fault);
    const auto& fit = std::get<BoardFit>(*now.fitted);
    return tr("✓ Calibrated with %1 places of the board: its corners are %2 pixels (RMS) from "
              "where "
              "this camera sees them.")
        .arg(fit.pictures)
        .arg(fit.rms, 0, 'f', 2);
}

QString CameraCalibration::faultText(CalibrationFault fault)
{
    switch (fault) {
    case CalibrationFault::TooFewPictures:
        return tr("● Hold the board to other places, still for a moment at each: ten are needed.");
    case CalibrationFault::NotAllOver:
        return tr("● Hold the board to where it has not been yet: into each corner and along each "
                  "side of the picture.");
    case CalibrationFault::NotTilted:
        return tr("● Tilt the board by 30 to 45 degrees to the left, to the right, up and down.");
    case CalibrationFault::Contradictory:
        break;
    }
    return tr("▲ The pictures do not fit one camera: the board has to be flat and the pictures "
              "sharp. Switch autofocus off, leave zoom and focus as they are, and begin anew.");
}

Result<void> CameraCalibration::save(const QString& file) const
{
    const auto fitted = progress().fitted;
    CARINA_EXPECTS(fitted && std::holds_alternative<BoardFit>(*fitted));
    const auto& fit = std::get<BoardFit>(*fitted);
    return writeCameraFile(
        file.toStdString(),
        {.model = fit.camera,
         .rms = fit.rms,
         .pictures = fit.pictures,
         .madeAt = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
}

} // namespace carina
