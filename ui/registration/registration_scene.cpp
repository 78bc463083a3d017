#include "ui/registration/registration_scene.h"

#include "engine/core/monotonic_clock.h"
#include "ui/scene/scene_parts.h"
#include "widgets/scene/labels/marker_shapes.h"
#include "widgets/scene/view/scene_view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kPulsesPerSecond = 1.5;
const Length kBall = millimetres(5.0);
const Length kSwollenBall = millimetres(9.0);
const Length kDiamond = millimetres(7.0);
const Length kRim = millimetres(2.5); ///< around a mark, dark: it stands out without colours, too
const Length kMargin = millimetres(40.0); ///< of the picture around landmarks and head
const Length kPointer = millimetres(100.0);
const Length kPointerRadius = millimetres(5.0);
const QColor kOpenColor{235, 235, 225};
const QColor kNextColor{250, 170, 40};
const QColor kTouchedColor{70, 190, 235};
const QColor kRimColor{8, 10, 14};
const QColor kStylusColor{210, 90, 200};
const std::string kStylus = "stylus";

enum class Marker : std::uint8_t { Open, Next, NextSwollen, Touched };
const std::array kRadii{kBall, kBall, kSwollenBall, kDiamond}; ///< by Marker

std::string bodyOf(Marker marker, std::size_t landmark)
{
    return "landmark " + std::to_string(landmark) + " " + std::to_string(int(marker));
}

std::string rimOf(std::size_t landmark) { return "rim " + std::to_string(landmark); }

Marker markerOf(const LandmarkRow& landmark, LocalTime time)
{
    if (landmark.isNext) {
        const double pulses = kPulsesPerSecond * toSeconds(time.time_since_epoch());
        return pulses - std::floor(pulses) < 0.5 ? Marker::Next : Marker::NextSwollen;
    }
    return landmark.spread_mm ? Marker::Touched : Marker::Open;
}

/// The side that a place of the body is best seen from.
ViewPreset viewOf(const Vec3& p_AQ)
{
    if (std::abs(p_AQ.x()) <= -p_AQ.y())
        return ViewPreset::Front;
    return p_AQ.x() > 0.0 ? ViewPreset::Left : ViewPreset::Right;
}

/// The landmarks, and the patient from there to the top of the head.
Box boundsToFrame(const std::vector<LandmarkRow>& landmarks, const PatientModel& patient)
{
    Box around;
    for (const LandmarkRow& landmark : landmarks)
        around.include(landmark.p_AQ);
    around.max.z() = std::max(around.max.z(), patient.top());
    around.min.array() -= kMargin.si;
    around.max.array() += kMargin.si;
    return around;
}

/// Puts a mark and its rim before the bone, on the line of sight: so the rim is whole, and both are
/// seen where the landmark is.
void mark(SceneFrame& frame, std::size_t landmark, Marker marker, const Vec3& p_AQ,
          const Vec3& p_A_eye)
{
    const Vec3 towardsEye = (p_A_eye - p_AQ).normalized();
    const double rim = (kRadii[std::size_t(marker)] + kRim).si;
    frame.bodies[rimOf(landmark)] = {RigidTransform::translation(p_AQ + 0.5 * rim * towardsEye),
                                     rim / kBall.si};
    frame.bodies[bodyOf(marker, landmark)] =
        RigidTransform::translation(p_AQ + 1.5 * rim * towardsEye);
}

/// X_AF of a pointer whose tip is at the stylus's tip and that runs along its shaft.
RigidTransform pointerAt(const StylusOnAnatomy& stylus)
{
    const Vec3 shaft_A = stylus.X_AS.translation() - stylus.p_AQ;
    return {Quat::FromTwoVectors(Vec3::UnitZ(), shaft_A), stylus.p_AQ};
}

} // namespace

RegistrationScene::RegistrationScene(SceneView& scene, const RegistrationModel& registration)
    : m_scene{scene}, m_registration{registration}
{
    m_scene.setFrameSource([this](int, LocalTime lit) { return frameAt(lit); });
    m_scene.showFrom(ViewPreset::Front);
    m_scene.nameSides();
    refresh();
}

void RegistrationScene::refresh()
{
    m_landmarks = m_registration.places();
    if (m_landmarks.size() > m_marked)
        addMarkers();
    const auto next = std::ranges::find_if(m_landmarks, &LandmarkRow::isNext);
    const QString name = next == m_landmarks.end() ? QString{} : next->name;
    if (name != m_next)
        m_scene.showFrom(name.isEmpty() ? ViewPreset::Front : viewOf(next->p_AQ));
    m_next = name;
}

std::optional<RegistrationScene::ShownError> RegistrationScene::showError(bool shown)
{
    const auto quadric_A = m_registration.fitting().errorQuadric();
    const auto range = shown && quadric_A
                           ? errorRange(*quadric_A, m_scene.parts(), frameAt(LocalTime{}))
                           : std::nullopt;
    if (!range) {
        m_scene.setErrorMap(std::nullopt);
        return std::nullopt;
    }
    const ErrorBands bands = bandsOver(*range);
    m_scene.setErrorMap(ErrorMap{*quadric_A, bands});
    return ShownError{bands, *range};
}

void RegistrationScene::addMarkers()
{
    std::vector<ScenePart> parts = sceneParts(m_registration.patient());
    const Box around = boundsToFrame(m_landmarks, m_registration.patient());
    const auto add = [&](std::string body, const QColor& color,
                         std::shared_ptr<const TriangleMesh> mesh) {
        parts.push_back({.name = body,
                         .id = static_cast<std::uint16_t>(parts.size() + 1),
                         .group = MaterialGroup::Tool,
                         .color = color,
                         .body = body,
                         .framed = false,
                         .levels = {std::move(mesh)}});
    };
    m_marked = m_landmarks.size();
    for (std::size_t i = 0; i < m_marked; ++i) {
        add(bodyOf(Marker::Open, i), kOpenColor, ballMarker(kBall));
        add(bodyOf(Marker::Next, i), kNextColor, ballMarker(kBall));
        add(bodyOf(Marker::NextSwollen, i), kNextColor, ballMarker(kSwollenBall));
        add(bodyOf(Marker::Touched, i), kTouchedColor, diamondMarker(kDiamond));
        add(rimOf(i), kRimColor, ballMarker(kBall));
    }
    add(kStylus, kStylusColor, pointerMarker(kPointer, kPointerRadius));
    m_scene.setParts(parts, around);
}

SceneFrame RegistrationScene::frameAt(LocalTime time) const
{
    const PatientModel& patient = m_registration.patient();
    // At rest, with the mouth shut.
    SceneFrame frame = sceneFrame({}, patient.lungs().field(), patient.throat(RigidTransform{}));
    for (std::size_t i = 0; i < m_landmarks.size(); ++i)
        mark(frame, i, markerOf(m_landmarks[i], time), m_landmarks[i].p_AQ,
             m_scene.camera().pose().p_A_eye);
    if (const auto stylus = m_registration.stylusOnAnatomy())
        frame.bodies[kStylus] = pointerAt(*stylus);
    return frame;
}

} // namespace carina
