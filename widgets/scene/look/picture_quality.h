#pragma once

#include "engine/core/session_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace carina
{

/// How the edges of a picture are drawn, from the quickest on.
enum class PictureQuality : std::uint8_t {
    Quick,    ///< one sample per pixel: edges have steps
    Smoothed, ///< one sample per pixel, edges smoothed afterwards (smoothed.frag)
    Fine,     ///< kSamplesPerPixel samples per pixel, averaged in linear light (fine.frag)
};
inline constexpr std::size_t kPictureQualities = 3;
inline constexpr int kSamplesPerPixel = 4; ///< of PictureQuality::Fine

/// How surfaces are drawn that a spotlight lights.
enum class SurfaceLook : std::uint8_t {
    Plain, ///< each part in its colour, lit at its vertices
    Moist, ///< mucosa with a wet film, fine relief and vessels, lit in each pixel (moist.frag)
};

/// By which programs and files know it: quick, smoothed or fine.
[[nodiscard]] const char* qualityName(PictureQuality quality);

/// Chooses the quality of a picture by the time that its frames take.
///
/// Every kFramesPerDecision frames, or earlier if their total exceeds the budget of that many,
/// their mean drawing time m decides. If it is above the budget, the quality falls by one. Where
/// the surfaces are drawn as fine as they ever are and m is below kComfort of the budget, the next
/// quality is tried. It stays only if
///
///     m - m_quick <= kMostAdded * max(m_quick, interval)
///
/// with the lesser m_quick of the two latest means of the quickest, and the interval in which
/// frames are drawn at most: this view, and others in the same thread, become slower by no more
/// than that. On a graphics card samples take next to no time; without one, pictures mostly stay
/// quick. What was too slow is tried again after kDecisionsApart decisions, as the computer may
/// have been busy.
class QualityChoice
{
public:
    static constexpr int kFramesPerDecision = 20;
    static constexpr int kFramesToSettle = 3; ///< after a change: shaders and textures are made
    static constexpr double kComfort = 0.8;
    static constexpr double kMostAdded = 0.05;
    static constexpr int kDecisionsApart = 500;

    /// Starts with the quickest. @pre the budget is above 0.
    explicit QualityChoice(Duration budgetPerFrame);

    /// Fixes the quality; std::nullopt chooses it by time again.
    void fix(std::optional<PictureQuality> quality);
    [[nodiscard]] bool isFixed() const { return m_fixed.has_value(); }

    /// Starts again with the quickest: what was measured is of another scene or size.
    void beginAnew();

    [[nodiscard]] PictureQuality quality() const { return m_fixed.value_or(m_quality); }

    /// From now on. @pre above 0
    void setBudget(Duration perFrame) { m_budget = perFrame; }

    /// Records the drawing time of a frame in this quality.
    /// @param interval at least, from one frame to the next
    /// @param isDetailFinest surfaces cannot be drawn finer than they are (DetailChoice)
    void frameTook(Duration drawing, Duration interval, bool isDetailFinest);

private:
    void decide(Duration mean, Duration interval, bool isDetailFinest);
    [[nodiscard]] bool addsTooMuch(Duration mean, Duration interval) const;
    void fall();
    void tryNext();
    void change(int steps);
    void startCounting();

    Duration m_budget;
    PictureQuality m_quality = PictureQuality::Quick;
    std::optional<PictureQuality> m_fixed;
    /// The two latest means of the quickest: one alone may be of a scene that is being prepared.
    std::array<Duration, 2> m_quick{Duration::max(), Duration::max()};
    bool m_isTried = false;           ///< this quality, since the last decision
    int m_decisionsLeft = 0;          ///< until the next may be tried
    int m_toSettle = kFramesToSettle; ///< frames that are not counted
    int m_frames = 0;
    Duration m_sum{};
};

} // namespace carina
