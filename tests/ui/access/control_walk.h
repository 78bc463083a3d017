#pragma once

#include "tests/support/soon.h"
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
#include <vector>

namespace carina::test
{

/// Whether a person works with it, and it is no part of another control.
inline bool isWorkedWith(const QWidget& widget)
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
    return isOne && !isPart;
}

/// Likewise, now.
inline bool isControl(const QWidget& widget)
{
    return isWorkedWith(widget) && widget.isVisible() && widget.isEnabled();
}

/// Names that two controls of a window have, in sight or not: a script would work the wrong one.
inline QStringList namesUsedTwice(const QWidget& window)
{
    QStringList once;
    QStringList twice;
    for (const QWidget* widget : window.findChildren<QWidget*>())
        if (const QString name = widget->objectName(); isWorkedWith(*widget) && !name.isEmpty())
            (once.contains(name) ? twice : once) << name;
    return twice;
}

/// A table in which nothing is chosen: it is looked at, as a label is.
inline bool isOnlyRead(const QWidget& widget)
{
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    return view && view->focusPolicy() == Qt::NoFocus
           && view->editTriggers() == QAbstractItemView::NoEditTriggers;
}

/// Those of a window that are in sight.
inline std::vector<QWidget*> controlsOf(QWidget& window)
{
    std::vector<QWidget*> controls;
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (isControl(*widget) && widget->window() == &window)
            controls.push_back(widget);
    return controls;
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
/// reached by Tab. Of radio buttons the chosen one is, and a table that is only read need not be.
inline QStringList faultsOfControls(QWidget& window)
{
    QStringList faults;
    const std::set<const QWidget*> reached = reachedByTab(window);
    for (QWidget* control : controlsOf(window)) {
        const QString which = QString::fromLatin1(control->metaObject()->className())
                              + QLatin1Char{' '} + control->objectName();
        if (QAccessible::queryAccessibleInterface(control)->text(QAccessible::Name).isEmpty())
            faults += which + QStringLiteral(" has no name");
        const auto* radio = qobject_cast<const QRadioButton*>(control);
        const QWidget* holder = control->focusProxy() ? control->focusProxy() : control;
        if (!reached.contains(holder) && !isOnlyRead(*control) && (!radio || radio->isChecked()))
            faults += which + QStringLiteral(" is not reached by Tab");
    }
    return faults;
}

/// Until what a window does at once after it was shown is done.
inline void awaitLayout()
{
    bool isDue = false;
    QTimer::singleShot(50, qApp, [&isDue] { isDue = true; });
    QVERIFY(soon([&isDue] { return isDue; }));
}

/// None of its controls has a fault, and there is one at least.
inline void verifyControls(QWidget& window)
{
    QVERIFY(!controlsOf(window).empty());
    const QStringList faults = faultsOfControls(window);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char{'\n'})));
}

} // namespace carina::test
