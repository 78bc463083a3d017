#pragma once

#include "engine/io/site/site.h"

namespace carina
{

/// Marks a result as stale. Of several causes the one first in StaleCause is kept: a changed
/// tracker invalidates a result whatever else has changed.
void makeStale(std::optional<StaleCause>& stale, StaleCause cause);

/// The registration and its verification.
void makeFitStale(Site& site, StaleCause cause);

/// The touched landmarks, and what is computed of them: makeFitStale.
void makeTouchesStale(Site& site, StaleCause cause);

} // namespace carina
