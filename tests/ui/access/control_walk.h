#pragma once

#include "tests/support/test_class.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QRadioButton>
#include <QScrollBar>

#include <set>

namespace carina::test
{

/// Whether a person works with it, and it is no part of another control.
inline bool isControl(const QWidget& widget)
{
    const bool isOne =
        qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget)
        || qobject_cast<const QAbstractSpinBox*>(&widget)
        || qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const QLineEdit*>(&widget)
        || qobject_cast<const QAbstractItemView*>(&widget);
    const QWidget* around = widget.parentWidget();
    const bool isPart =
        qobject_cast<const QScrollBar*>(&widget) || qobject_cast<const QHeaderView*>(&widget)
        || widget.objectName().startsWith(QLatin1String{"qt_"})
        || qobject_cast<const QComboBox*>(around) || qobject_cast<const QAbstractSpinBox*>(around)
        || qobject_cast<const QLineEdit*>(around) || qobject_cast<const QAbstractItemView*>(around)
        || (around && around->inherits("QTabBar"));
    return isOne && !isPart && widget.isVisible() && widget.isEnabled();
}

/// By Tab from where the keyboard is, once around.
inline std::set<const QWidget*> reachedByTab(QWidget& window)
{
    constexpr int kMostSteps = 300;
    std::set<const QWidget*> reached;
    for (int step = 0; step < kMostSteps; ++step) {
        QWidget* at = window.focusWidget() ? window.focusWidget() : &window;
        if (!reached.insert(at).second)
            break;
        QTest::keyClick(at, Qt::Key_Tab);
    }
    return reached;
}

/// What is wrong for who has no eyes or no mouse: each control that is in sight has a name, and is
/// reached by Tab. Of radio buttons the chosen one is.
inline QStringList faultsOfControls(QWidget& window)
{
    QStringList faults;
    const std::set<const QWidget*> reached = reachedByTab(window);
    for (QWidget* control : window.findChildren<QWidget*>()) {
        if (!isControl(*control) || control->window() != &window)
            continue;
        const QString which = QString::fromLatin1(control->metaObject()->className())
                              + QLatin1Char{' '} + control->objectName();
        if (QAccessible::queryAccessibleInterface(control)->text(QAccessible::Name).isEmpty())
            faults += which + QStringLiteral(" has no name");
        const auto* radio = qobject_cast<const QRadioButton*>(control);
        const QWidget* holder = control->focusProxy() ? control->focusProxy() : control;
        if (!reached.contains(holder) && (!radio || radio->isChecked()))
            faults += which + QStringLiteral(" is not reached by Tab");
    }
    return faults;
}

} // namespace carina::test
