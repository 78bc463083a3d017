#pragma once

#include "models/registration/stylus_watch.h"
#include "models/site/site_editor.h"

namespace carina
{

/// Finds the tip of the stylus, which begins and ends by itself, and the axis of its shaft.
class StylusTask
{
public:
    /// @pre both outlive this.
    StylusTask(SiteEditor& editor, StylusWatch& watch);

    /// The calibration of the stylus in hand; null before there is one.
    [[nodiscard]] const StylusTip* tip() const;

    [[nodiscard]] bool isLookingForTip() const { return m_watch.use() == StylusUse::Pivot; }
    [[nodiscard]] bool isSpinning() const { return m_watch.use() == StylusUse::Spin; }
    [[nodiscard]] const PivotProgress& pivot() const { return m_watch.pivot(); }

    /// Waits for the stylus to be swung; a calibration from before stays until then.
    void findTip();
    /// Takes the poses of the next seconds, in which the stylus is spun about its shaft.
    /// @pre its tip is known.
    void findAxis();
    void stop();

    void take(const StylusNews& news);

private:
    void takeAxis(const Result<SpinCalibration>& axis);

    SiteEditor& m_editor;
    StylusWatch& m_watch;
};

} // namespace carina
