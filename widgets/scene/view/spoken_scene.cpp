#include "widgets/scene/view/spoken_scene.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QGuiApplication>
#include <QVariant>

namespace carina
{
namespace
{

constexpr const char* kSpokenWindow = "spokenWindow"; ///< property: the window of the scene

const QWindow* windowOf(const QObject& container)
{
    return container.property(kSpokenWindow).value<QWindow*>();
}

class SpokenScene : public QAccessibleWidget
{
public:
    explicit SpokenScene(QWidget* container) : QAccessibleWidget{container, QAccessible::Graphic} {}

    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        const QWidget* view = widget()->parentWidget();
        return which == QAccessible::Name && view ? view->accessibleName()
                                                  : QAccessibleWidget::text(which);
    }

    [[nodiscard]] QAccessible::State state() const override
    {
        QAccessible::State state = QAccessibleWidget::state();
        state.focused =
            widget()->hasFocus() || QGuiApplication::focusWindow() == windowOf(*widget());
        return state;
    }
};

QAccessibleInterface* spokenScene(const QString&, QObject* object)
{
    return windowOf(*object) ? new SpokenScene{static_cast<QWidget*>(object)} : nullptr;
}

} // namespace

void speakScene(QWidget& container, const QWindow& window)
{
    static const bool isInstalled = [] {
        QAccessible::installFactory(spokenScene);
        return true;
    }();
    Q_UNUSED(isInstalled)
    container.setProperty(kSpokenWindow, QVariant::fromValue(const_cast<QWindow*>(&window)));
    QObject::connect(qGuiApp, &QGuiApplication::focusWindowChanged, &container,
                     [&container, &window](const QWindow* now) {
                         if (now != &window)
                             return;
                         QAccessibleEvent event{&container, QAccessible::Focus};
                         QAccessible::updateAccessibility(&event);
                     });
}

} // namespace carina
