#pragma once

#include "engine/display/time_of_light.h"
#include "widgets/scene/labels/part_labels.h"
#include "widgets/scene/labels/side_labels.h"
#include "widgets/scene/look/error_map.h"
#include "widgets/scene/look/part_look.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/detail_choice.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/frame_statistics.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/scene_frame.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

struct SceneCamera;
class SceneRenderer;
class SceneWindow;

/// A 3-D view of a patient and the tools in it, about 60 times a second while it can be seen.
///
/// It knows surfaces, poses and amplitudes, and nothing of where they come from: right before each
/// frame it asks a frame source, and what the source answers is what that frame shows.
class SceneView : public QWidget
{
    Q_OBJECT

public:
    /// Asked for the state of the scene when the frame will be lit; the parts that share their
    /// level of detail will be drawn in this one.
    using FrameSource = std::function<SceneFrame(int level, LocalTime lit)>;
    using FrameListener = std::function<void(const DrawnFrame&)>;

    /// @pre prepareGraphics() was called, and graphicsDriver() has a value.
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Shows these parts and no others, as usual, framed by the present preset.
    /// @param alsoFramed what a preset makes sure to show besides them, in A
    /// @pre ids are unique.
    void setParts(std::span<const ScenePart> parts, const Box& alsoFramed = {});
    [[nodiscard]] const std::vector<ScenePart>& parts() const { return m_parts; }
    /// Shows parts apart from the usual way from now on. The camera stays where it is.
    void setLooks(const PartLooks& looks);
    [[nodiscard]] const PartLooks& looks() const { return m_looks; }
    /// Cuts the scene open, or no more.
    void setSection(const std::optional<Section>& section);
    /// Draws the error of a registration in place of the parts' colours, or no more.
    void setErrorMap(const std::optional<ErrorMap>& map);

    void setFrameSource(FrameSource source) { m_source = std::move(source); }
    /// Called after each frame, when its buffers were swapped.
    void onFrameDrawn(FrameListener listener) { m_listener = std::move(listener); }

    void showFrom(ViewPreset preset);
    /// The view's own, which shows a frame without eyes.
    [[nodiscard]] const OrbitCamera& camera() const;
    /// Says at the edges from now on which are the patient's right and left, but to no headset.
    void nameSides() { m_sides.emplace(*this); }
    /// Whether mouse and keys move the camera; they do from the start.
    void setInteractive(bool interactive);
    void setBackground(const QColor& color);

    /// A level of detail for all parts to stay at, or none to choose by what is seen of each part
    /// and by the time that frames take.
    void setFixedLevel(std::optional<int> level);
    /// The level of detail that the parts which share theirs are drawn in, 0 the finest.
    [[nodiscard]] int level() const { return m_detail.sharedLevel(); }
    /// Drawn in the latest frame.
    [[nodiscard]] std::size_t triangles() const { return m_detail.triangles(); }
    [[nodiscard]] FrameStatistics statistics() const { return m_times.statistics(); }

    /// What the window shows at the latest frame. Null while the view cannot be seen.
    [[nodiscard]] QImage picture();

    /// In how many pixels of the latest frame, those of all eyes together, each part, by id, is
    /// drawn: an opaque part where no opaque part is in front of it; a translucent part where it is
    /// the nearest of its material group and nothing opaque, and no earlier translucent group, is
    /// in front of it. Later groups are seen through and hide nothing. Zero for all while the view
    /// cannot be seen.
    [[nodiscard]] std::map<std::uint16_t, std::size_t> visiblePixels();

Q_SIGNALS:
    /// A place in the picture was clicked: the ray from the eye of the view's own camera through
    /// it, in A, the direction of length 1.
    void clicked(const carina::Vec3& p_A_eye, const carina::Vec3& dir_A);

private:
    void drawFrame();
    void drawExposed(LocalTime asked);
    void placeLabels(const SceneFrame& frame, const std::vector<SceneCamera>& cameras);
    void sendRay(const QPointF& position);
    void chooseDetail();
    [[nodiscard]] std::vector<SceneCamera> camerasOf(const SceneFrame& frame) const;

    SceneWindow* m_window; ///< owned by its container, a child of this
    std::unique_ptr<SceneRenderer> m_renderer;
    std::vector<ScenePart> m_parts;
    PartLooks m_looks;
    PartLabels m_labels;
    std::optional<SideLabels> m_sides;
    FrameSource m_source;
    FrameListener m_listener;
    DetailChoice m_detail;
    FrameTimes m_times;
    TimeOfLight m_timeOfLight;
    std::vector<DetailEye> m_eyes; ///< of the latest frame
    QTimer m_tick;
};

} // namespace carina
