#include "ui/registration/tracker_page.h"

namespace carina
{

QString TrackerPage::actionText() const { return tr("&Use this tracker"); }

void TrackerPage::act() { registration().useTracker(); }

} // namespace carina
