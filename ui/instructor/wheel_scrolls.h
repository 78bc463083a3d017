#pragma once

class QWidget;

namespace carina
{

/// Has the wheel scroll what a panel stands in, also where the mouse is over a number, a slider or
/// a choice: who scrolls changes none of these but the number or slider that has the keyboard,
/// which no wheel gives; a choice, each step of which is a decision, not even then. For the
/// controls that the panel has now.
void letWheelScroll(QWidget& panel);

} // namespace carina
