#pragma once

#include "engine/core/units.h"
#include "engine/display/time_of_light.h"
#include "widgets/scene/figures/figure_names.h"
#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/labels/part_labels.h"
#include "widgets/scene/labels/side_labels.h"
#include "widgets/scene/look/error_map.h"
#include "widgets/scene/look/part_look.h"
#include "widgets/scene/look/picture_quality.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/detail_choice.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/frame_statistics.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/parts_on_ray.h"
#include "widgets/scene/view/resting_picture.h"
#include "widgets/scene/view/scene_frame.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <chrono>
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

/// Which part is seen in each pixel of a picture.
struct IdPicture {
    int width = 0;
    int height = 0;
    std::vector<std::optional<std::uint16_t>> ids{}; ///< row by row from the top
};

/// What a view draws of its parts, and how.
struct SceneSettings {
    std::optional<Section> section{};
    PartLooks looks{};

    friend bool operator==(const SceneSettings&, const SceneSettings&) = default;
};

/// A 3-D view of a patient and tools, redrawn about 60 times a second while it is visible.
///
/// It does not depend on the origin of surfaces, poses and amplitudes: immediately before each
/// frame it calls a frame source, and draws the state that this returns.
class SceneView : public QWidget
{
    Q_OBJECT

public:
    /// Returns the state of the scene at the time when the frame will be lit; `level` is the level
    /// of detail in which the parts that share theirs will be drawn.
    using FrameSource = std::function<SceneFrame(int level, LocalTime lit)>;
    using FrameListener = std::function<void(const DrawnFrame&)>;
    using IdListener = std::function<void(const IdPicture&, const SceneFrame&)>;

    /// @pre prepareGraphics() was called, and graphicsDriver() has a value.
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Replaces the parts, drawn as usual and framed by the present preset.
    /// @param alsoFramed a box in A that presets show as well
    /// @pre ids are unique.
    void setParts(std::span<const ScenePart> parts, const Box& alsoFramed = {});
    [[nodiscard]] const std::vector<ScenePart>& parts() const { return m_parts; }
    /// Replaces the figures beside the parts, which are kept. Presets do not frame them, sections
    /// do not cut them, and they have no looks. May be called by the frame source.
    /// @pre ids are unique among the parts of all figures and those of the scene.
    void setFigures(std::span<const SceneFigure> figures);
    /// Sets how parts are drawn differently from their material group. The camera does not move.
    void setLooks(const PartLooks& looks);
    [[nodiscard]] const PartLooks& looks() const { return m_own.looks; }
    /// Sets the section plane; std::nullopt removes it.
    void setSection(const std::optional<Section>& section);
    /// The view's own settings.
    [[nodiscard]] const SceneSettings& settings() const { return m_own; }
    /// Draws these settings in place of the view's own from now on, which stay as they are and may
    /// be changed meanwhile; std::nullopt: its own again. New parts end it.
    void drawInstead(const std::optional<SceneSettings>& settings);
    [[nodiscard]] const std::optional<SceneSettings>& drawnInstead() const { return m_instead; }
    /// Draws the error map of a registration in place of the parts' colours; std::nullopt ends
    /// this.
    void setErrorMap(const std::optional<ErrorMap>& map);

    /// Lights the scene by a lamp beside the eye alone, as inside a body; what is at this distance
    /// is as bright as its colour. std::nullopt ends this.
    void setSpotlight(std::optional<Length> trueColorAt);

    /// What is nearer than this to the plane of an eye of a frame is not drawn; std::nullopt: a
    /// share of the distance of what is farthest.
    void setNearest(std::optional<Length> nearest);

    void setFrameSource(FrameSource source) { m_source = std::move(source); }
    /// The listener is called after each frame, when its buffers were swapped; also after one that
    /// is like the picture that rests in the window, and so is not drawn again.
    void onFrameDrawn(FrameListener listener) { m_listener = std::move(listener); }

    /// The names of parts as they were written last, in pixels of the view; `wish` counts the
    /// labelled parts that are not hidden.
    [[nodiscard]] const std::vector<PlacedName>& placedNames() const { return m_labels.placed(); }

    /// The names of figures, likewise.
    [[nodiscard]] const std::vector<PlacedName>& placedFigureNames() const
    {
        return m_figureNames.placed();
    }

    /// Draws so often at most; usually every 16 ms.
    void drawEvery(std::chrono::milliseconds interval) { m_interval = interval; }

    void showFrom(ViewPreset preset);
    /// Shows what a camera in this pose sees. @pre that of OrbitCamera::look
    void showFrom(const CameraPose& pose);
    /// Draws from now on from the camera of another view, with its looks and its section, and takes
    /// no input. @pre both have the same parts whenever this draws; the other one outlives this
    void follow(const SceneView& other);
    /// Is only looked at from now on: neither mouse nor keyboard have an effect.
    void takeNoInput();
    /// How the patient lies, for the view's own camera.
    void setLie(Lie lie);
    /// The view's own camera, used for frames without a list of eyes.
    [[nodiscard]] const OrbitCamera& camera() const;
    /// The parts as they are drawn, without hidden ones.
    [[nodiscard]] const std::vector<ScenePart>& shownParts() const { return m_shown; }
    /// The latest frame, and how the view's own camera or what was drawn in its place saw it.
    [[nodiscard]] const SceneFrame& frame() const { return m_frame; }
    [[nodiscard]] const SceneSight& sight() const { return m_sight; }
    /// The ray under the mouse; std::nullopt while it is not over the picture.
    [[nodiscard]] std::optional<SightRay> rayUnderMouse() const;
    /// Labels the right and left of a patient at the edges, except in a headset: of the body with
    /// this name, or of a patient that is fixed in A.
    void nameSides(std::string body = {}) { m_sides.emplace(*this, std::move(body)); }
    /// Keeps labels and names, except in a headset, out of so many pixels at the upper edge, over
    /// which something else lies.
    void keepNamesBelow(int covered) { m_covered = covered; }
    void setBackground(const QColor& color);

    /// Fixes the level of detail of all parts; std::nullopt chooses it by visible error and drawing
    /// time (DetailChoice).
    void setFixedLevel(std::optional<int> level);
    /// Fixes how edges are drawn; std::nullopt chooses it by drawing time (QualityChoice).
    ///
    /// While it is not fixed, a picture that does not change is drawn in full detail and the finest
    /// quality once, and then rests (RestingPicture).
    void setFixedQuality(std::optional<PictureQuality> quality);
    /// Fixes how a spotlight shows surfaces; std::nullopt: plain in the quickest quality, else
    /// moist.
    void setFixedLook(std::optional<SurfaceLook> look);
    /// Of the latest frame.
    [[nodiscard]] PictureQuality quality() const { return m_drawnQuality; }
    /// Whether the latest frame was not drawn as is set yet, as a shader program is being compiled.
    [[nodiscard]] bool isPreparing() const;
    /// The common level of detail of the parts that share theirs; 0 is the finest.
    [[nodiscard]] int level() const { return m_detail.sharedLevel(); }
    /// The number of triangles in the latest frame.
    [[nodiscard]] std::size_t triangles() const { return m_detail.triangles(); }
    [[nodiscard]] FrameStatistics statistics() const { return m_times.statistics(); }

    /// The picture of the latest frame; null while the view is not visible.
    [[nodiscard]] QImage picture();

    /// The number of pixels of the latest frame, summed over all eyes, in which each part, by id,
    /// is visible: an opaque part where no opaque part is in front of it; a translucent part where
    /// it is the nearest of its material group and no opaque part, and no earlier translucent
    /// group, is in front of it. Later groups hide nothing. Zero for all while the view is not
    /// visible.
    [[nodiscard]] std::map<std::uint16_t, std::size_t> visiblePixels();

    /// The id of the nearest opaque part in each pixel of the latest frame, row by row from the
    /// top; translucent parts hide nothing. Empty while the view is not visible.
    [[nodiscard]] IdPicture opaqueIds();

    /// The same of the next frame, in at most 320x240 pixels of the same shape, without waiting for
    /// it: the listener has it, with that frame, one or two frames later. Without effect while one
    /// is under way; new parts or looks end that.
    void askForIds() { m_asksForIds = true; }
    void onIdsRead(IdListener listener) { m_idListener = std::move(listener); }

Q_SIGNALS:
    /// A point in the picture was clicked: the ray through it from the eye that sees it there, in
    /// A, with a unit direction.
    void clicked(const carina::Vec3& p_A_eye, const carina::Vec3& dir_A);
    // Of SceneWindow, while a frame's head is steered.
    void headTurned(double right, double down);
    void headNeared(double factor);
    void headReturned();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void drawFrame();
    void drawExposed(LocalTime asked);
    void drawScene(const SceneFrame& frame, const std::vector<SceneCamera>& cameras,
                   PictureQuality quality);
    void takeTime(Duration took);
    [[nodiscard]] bool hasToBeDrawn(const SceneFrame& frame,
                                    const std::vector<SceneCamera>& cameras);
    void beginToRead(const SceneFrame& frame);
    void tellIds();
    void takeFrom(const SceneView& other);
    void placeLabels(const SceneFrame& frame, const std::vector<SceneCamera>& cameras);
    void sendRay(const QPointF& position);
    [[nodiscard]] std::optional<SightRay> rayAt(const QPointF& position) const;
    [[nodiscard]] const SceneSettings& inForce() const { return m_instead ? *m_instead : m_own; }
    void applyLooks();
    void applySection();
    void chooseDetail();
    [[nodiscard]] std::vector<SceneCamera> camerasOf(const SceneFrame& frame) const;
    [[nodiscard]] std::vector<EyeSight> sightsOf(const std::vector<SceneCamera>& cameras) const;

    SceneWindow* m_window; ///< owned by its container, a child of this
    std::unique_ptr<SceneRenderer> m_renderer;
    std::vector<ScenePart> m_parts;
    std::vector<ScenePart> m_figureParts;
    std::vector<ScenePart> m_shown; ///< m_parts with the looks that are drawn
    SceneSettings m_own;
    std::optional<SceneSettings> m_instead;
    SceneFrame m_frame; ///< the latest
    SceneSight m_sight; ///< likewise
    PartLabels m_labels;
    FigureNames m_figureNames;
    std::optional<SideLabels> m_sides;
    int m_covered = 0; ///< pixels at the upper edge
    const SceneView* m_followed = nullptr;
    FrameSource m_source;
    FrameListener m_listener;
    IdListener m_idListener;
    bool m_asksForIds = false;
    SceneFrame m_readFrame; ///< whose ids are read
    std::chrono::milliseconds m_interval{16};
    DetailChoice m_detail;
    QualityChoice m_quality;
    PictureQuality m_drawnQuality = PictureQuality::Quick;
    std::optional<SurfaceLook> m_look;
    RestingPicture m_rest;
    std::vector<SceneCamera> m_cameras; ///< of the latest frame
    FrameTimes m_times;
    TimeOfLight m_timeOfLight;
    std::vector<DetailEye> m_eyes; ///< of the latest frame
    QTimer m_tick;
    std::optional<Length> m_nearest;
};

} // namespace carina
