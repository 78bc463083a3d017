#pragma once

#include "ui/instructor/reading_order.h"

#include <QDockWidget>

namespace carina
{

/// A panel of the console. While it floats, Tab goes through it as it is read.
class PanelDock : public QDockWidget
{
public:
    using QDockWidget::QDockWidget;

protected:
    bool focusNextPrevChild(bool next) override
    {
        return isWindow() ? focusNextAsRead(*this, next) : QDockWidget::focusNextPrevChild(next);
    }
};

} // namespace carina
