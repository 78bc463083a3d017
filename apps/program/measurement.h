#pragma once

#include "apps/program/seen_overlay.h"
#include "models/station/frame_log.h"
#include "ui/scene/station_scene.h"

#include <QDir>
#include <QJsonObject>
#include <QPixmap>
#include <QWidget>

#include <optional>

namespace carina::program
{

/// What a program measured of itself while people, or a script, used it: its frames as drawn, the
/// lung volumes of the vertices drawn, and, taken when the tube has lain in place for a second, a
/// picture of its window and the visible pixels of each part. Read by `carina-lab summary`.
class Measurement
{
public:
    /// Logs every frame from now on. @pre window and scene outlive this.
    Measurement(QWidget& window, StationScene& scene);

    /// Measures what a headset shows against the simulator's truth, too; for a headset's output it
    /// adds "overlay" to what is written.
    void compareWith(TrueView truth);

    /// Forgets what was measured: another patient is drawn from now on.
    void startAfresh();

    /// Writes NAME.png, NAME.json (what was measured, and `extra` with it) and NAME_frames.csv.
    /// @returns NoGraphics where vertices cannot be read back; FileUnwritable with the path.
    [[nodiscard]] Result<void> write(const QDir& folder, const QString& name,
                                     const QJsonObject& extra);

private:
    void logFrame(const DrawnFrame& drawn, const StationMoment& moment);
    void takePicture();
    [[nodiscard]] Result<void> measureVolumes();
    [[nodiscard]] QJsonObject visiblePixels() const;

    QWidget& m_window;
    StationScene& m_scene;
    std::vector<LoggedFrame> m_frames;
    std::vector<ChestPose> m_poses; ///< of the chest, as drawn in each of them
    std::optional<SeenOverlay> m_overlay;
    std::optional<LocalTime> m_inPlaceSince; ///< the tube, without a break until the latest frame
    bool m_pictureDue = false;               ///< of this stay in place
    QPixmap m_picture;
    QJsonObject m_visiblePixels; ///< when the picture was taken
};

} // namespace carina::program
