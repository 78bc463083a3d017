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

/// Measurements of a running program: its frames as drawn, the lung volumes from the drawn
/// vertices, and, when the tube has been in place for a second, a picture of the window and the
/// visible pixels of each part. `carina-lab summary` reads the result.
class Measurement
{
public:
    /// Logs every frame from now on. @pre window and scene outlive this.
    Measurement(QWidget& window, StationScene& scene);

    /// Also measures the overlay error in a headset against the simulator's ground truth; adds
    /// "overlay" to the output.
    void compareWith(TrueView truth);

    /// Discards all measurements, because another patient is drawn from now on.
    void startAfresh();

    /// Writes NAME.png, NAME.json (the measurements and `extra`) and NAME_frames.csv.
    /// @returns NoGraphics if vertices cannot be read back; FileUnwritable with the path.
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
    std::vector<ChestPose> m_poses; ///< of the chest, as drawn in each frame
    std::optional<SeenOverlay> m_overlay;
    std::optional<LocalTime> m_inPlaceSince; ///< start of the tube's present stay in place
    bool m_pictureDue = false;               ///< of this stay in place
    QPixmap m_picture;
    QJsonObject m_visiblePixels; ///< when the picture was taken
};

} // namespace carina::program
