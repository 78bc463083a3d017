#include "apps/program/measurement.h"

#include "engine/core/monotonic_clock.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "widgets/scene/surfaces/drawn_vertices.h"
#include "widgets/scene/view/scene_view.h"

#include <QJsonDocument>
#include <QSaveFile>
#include <QScreen>
#include <QTimer>

#include <algorithm>
#include <map>

namespace carina::program
{
namespace
{

constexpr Duration kHalfRefresh = std::chrono::microseconds{8333}; ///< of a screen with 60 Hz
constexpr Length kInPlace = millimetres(6.0);
constexpr Duration kRest = std::chrono::seconds{1}; ///< in place before the picture

LoggedFrame logged(const DrawnFrame& drawn, const StationMoment& moment)
{
    LoggedFrame entry;
    entry.local = machineTime(drawn.lit);
    entry.session = drawn.frame.time;
    entry.level = drawn.level;
    for (std::size_t lung = 0; lung < entry.amplitude.size(); ++lung)
        entry.amplitude[lung] = static_cast<float>(moment.pose.lungs[lung].diaphragm);
    if (moment.tube && moment.tube->validity != Validity::Lost)
        entry.X_AE = moment.tube->X_FO;
    entry.sampleAge = moment.sampleAge;
    if (moment.patient)
        entry.X_AV = moment.patient->acted.X_AO;
    return entry;
}

/// Whether the tube's tip is where it belongs, in the airway as that lies.
bool isInPlace(const LoggedFrame& frame, const TubeShape& tube, const NeckField& neck)
{
    return frame.X_AE && tipFromPlace(tube, neck, *frame.X_AE) < kInPlace;
}

/// The finest of the surface's own levels that a level of the scene shows.
const TriangleMesh& shownLevel(const PatientSurface& surface, int level)
{
    return *surface.levels[std::min(std::size_t(level), surface.levels.size() - 1)];
}

} // namespace

Measurement::Measurement(QWidget& window, StationScene& scene) : m_window{window}, m_scene{scene}
{
    m_scene.onFrameDrawn([this](const DrawnFrame& drawn, const StationMoment& moment) {
        if (moment.time != SessionTime{}) // in a session
            logFrame(drawn, moment);
    });
}

void Measurement::compareWith(TrueView truth)
{
    m_overlay.emplace(std::move(truth), m_scene.patient().landmarks());
}

void Measurement::startAfresh()
{
    m_frames.clear();
    m_overlay.reset();
    m_inPlaceSince.reset();
    m_pictureDue = false;
    m_picture = {};
}

void Measurement::logFrame(const DrawnFrame& drawn, const StationMoment& moment)
{
    m_frames.push_back(logged(drawn, moment));
    m_poses.push_back(moment.pose);
    if (m_overlay && drawn.frame.eyes && !drawn.frame.eyes->empty() && moment.head)
        m_overlay->add(moment.head->X_FO, moment.time + (drawn.swapped + kHalfRefresh - drawn.lit));
    const PatientModel& patient = m_scene.patient();
    if (!isInPlace(m_frames.back(), patient.tube(), patient.neck(moment.headPosition))) {
        m_inPlaceSince.reset();
        return;
    }
    if (!m_inPlaceSince) {
        m_inPlaceSince = drawn.asked;
        m_pictureDue = true;
    }
    if (m_pictureDue && drawn.asked - *m_inPlaceSince >= kRest) {
        m_pictureDue = false;
        // After this frame: reading the picture back draws again.
        QTimer::singleShot(0, &m_window, [this] { takePicture(); });
    }
}

void Measurement::takePicture()
{
    m_visiblePixels = visiblePixels();
    m_picture = m_window.screen()->grabWindow(m_window.winId());
}

Result<void> Measurement::measureVolumes()
{
    for (const PatientSurface& surface : m_scene.patient().surfaces()) {
        const std::optional<Side> side = lungSide(surface.description.role);
        if (!side)
            continue;
        const std::size_t lung = *side == Side::Right ? 0 : 1;
        std::map<int, DrawnVertices> readers; // one for each level that was drawn
        const ChestRegion region = regionOf(surface.description.role);
        const ChestField& field = m_scene.patient().lungs().field();
        for (std::size_t n = 0; n < m_frames.size(); ++n) {
            LoggedFrame& frame = m_frames[n];
            const TriangleMesh& mesh = shownLevel(surface, frame.level);
            auto reader = readers.find(frame.level);
            if (reader == readers.end()) {
                auto made = DrawnVertices::of(mesh);
                if (!made)
                    return tl::unexpected(made.error());
                reader = readers.emplace(frame.level, std::move(*made)).first;
            }
            auto vertices = reader->second.at(field, motionOf(region, m_poses[n], field));
            if (!vertices)
                return tl::unexpected(vertices.error());
            const TriangleMesh drawn{std::move(vertices->positions), {}, mesh.triangles};
            frame.volume_ml[lung] += inMillilitres(cubicMetres(signedVolume(drawn)));
        }
    }
    return {};
}

QJsonObject Measurement::visiblePixels() const
{
    const auto counts = m_scene.scene().visiblePixels();
    QJsonObject pixels;
    std::uint16_t id = 0;
    for (const PatientSurface& surface : m_scene.patient().surfaces()) {
        const auto found = counts.find(++id);
        const auto count = found != counts.end() ? qint64(found->second) : qint64{0};
        const QString name = QString::fromStdString(surface.name);
        pixels[name] = pixels[name].toInteger() + count;
    }
    return pixels;
}

Result<void> Measurement::write(const QDir& folder, const QString& name, const QJsonObject& extra)
{
    if (m_picture.isNull())
        takePicture(); // the tube never was in place
    const QString picture = folder.filePath(name + QStringLiteral(".png"));
    if (!m_picture.save(picture))
        return fail(Errc::FileUnwritable, picture.toStdString());
    if (auto measured = measureVolumes(); !measured)
        return measured;
    if (auto wrote = writeFrames(folder.filePath(name + QStringLiteral("_frames.csv")), m_frames);
        !wrote)
        return wrote;

    QJsonObject report = extra;
    report[QStringLiteral("schema")] = QStringLiteral("carina.view/1");
    report[QStringLiteral("anatomy")] = QString::fromStdString(m_scene.patient().name());
    report[QStringLiteral("anatomy_hash")] =
        QString::fromStdString(m_scene.patient().contentHash());
    report[QStringLiteral("screenshot")] = picture;
    const int level = m_frames.empty() ? 0 : m_frames.back().level;
    report[QStringLiteral("level")] = level;
    report[QStringLiteral("triangles")] = qint64(m_scene.scene().triangles());
    report[QStringLiteral("visible_pixels")] = m_visiblePixels;
    if (m_overlay)
        report[QStringLiteral("overlay")] = m_overlay->report();
    QSaveFile file{folder.filePath(name + QStringLiteral(".json"))};
    if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument{report}.toJson()) < 0
        || !file.commit())
        return fail(Errc::FileUnwritable, file.fileName().toStdString());
    return {};
}

} // namespace carina::program
