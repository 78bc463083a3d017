#include "ui/instructor/wheel_scrolls.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace carina
{
namespace
{

class WheelGuard : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isList = qobject_cast<QComboBox*>(watched) != nullptr;
        if (event->type() != QEvent::Wheel
            || (static_cast<QWidget*>(watched)->hasFocus() && !isList))
            return false;
        event->ignore(); // what the control stands in gets it
        return true;
    }
};

template <class Control> void guardFromWheel(QWidget& panel, WheelGuard& guard)
{
    for (Control* control : panel.findChildren<Control*>()) {
        if (control->focusPolicy() == Qt::WheelFocus)
            control->setFocusPolicy(Qt::StrongFocus);
        control->installEventFilter(&guard);
    }
}

} // namespace

void letWheelScroll(QWidget& panel)
{
    auto* guard = new WheelGuard{&panel};
    guardFromWheel<QAbstractSpinBox>(panel, *guard);
    guardFromWheel<QComboBox>(panel, *guard);
    guardFromWheel<QSlider>(panel, *guard);
}

} // namespace carina
