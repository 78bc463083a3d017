#pragma once

#include "tests/models/registration/registration_site.h"
#include "ui/registration/registration_window.h"

#include <QApplication>
#include <QPushButton>
#include <QTest>

namespace carina
{

/// The wizard's window on a technician's desk, worked as a person does: by what can be clicked, by
/// keys, and by the stylus.
struct RegistrationDesk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();
    PoseRecording recording{[] { return std::optional<SessionTime>{}; }};
    std::unique_ptr<RegistrationWindow> window =
        std::make_unique<RegistrationWindow>(*model, recording);

    explicit RegistrationDesk(bool hasTools = false) : site{hasTools}
    {
        window->resize(1280, 900);
        window->show();
        QApplication::setActiveWindow(window.get()); // the display has no window manager
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *window->findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QPushButton& button(const char* name) const { return find<QPushButton>(name); }

    /// With the mouse. @returns false where nobody could.
    [[nodiscard]] bool click(const char* name) const
    {
        QPushButton& it = button(name);
        if (!it.isVisible() || !it.isEnabled())
            return false;
        QTest::mouseClick(&it, Qt::LeftButton);
        return true;
    }
    /// A key, to what has the focus.
    void press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) const
    {
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : window.get(), key, with);
    }
    /// Tab until that has the focus. @returns false where it never gets it.
    [[nodiscard]] bool tabTo(const char* name) const
    {
        for (int i = 0; i < 60; ++i) {
            if (find<QWidget>(name).hasFocus())
                return true;
            press(Qt::Key_Tab);
        }
        return false;
    }
};

} // namespace carina
