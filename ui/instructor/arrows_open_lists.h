#pragma once

class QWidget;

namespace carina
{

/// Has the keys that step through a closed list open it instead: each choice of a panel acts at
/// once, and who goes past others to the one that is meant means none of those. A letter chooses
/// what begins with it. For the lists that the panel has now.
void letArrowsOpenLists(QWidget& panel);

} // namespace carina
