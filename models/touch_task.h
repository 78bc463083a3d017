#pragma once

#include "models/landmark_task.h"
#include "models/stylus_watch.h"

namespace carina
{

/// Takes the landmarks on the manikin: by holding the stylus still, or by a key or foot switch. In
/// any order, where the geometry tells which one was touched.
class TouchTask
{
public:
    /// @pre all outlive this.
    TouchTask(SiteEditor& editor, StylusWatch& watch, const LandmarkTask& landmarks);

    /// The landmark that is asked for: the chosen one, or the first that has no fresh touch.
    [[nodiscard]] std::optional<std::size_t> next() const;
    /// The landmark that shall be touched now, whatever the geometry says.
    void choose(std::optional<std::size_t> landmark);
    [[nodiscard]] std::optional<std::size_t> chosen() const { return m_chosen; }

    /// Watches for touches from now on, if the tip of the stylus is known.
    void start();
    /// Takes the point that the tip is at, without waiting.
    void takeNow();
    void take(const StylusNews& news);

private:
    void take(const StylusTouch& touch);
    void take(const StylusTouch& touch, std::size_t landmark);

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const LandmarkTask& m_landmarks;
    std::optional<std::size_t> m_chosen;
};

} // namespace carina
