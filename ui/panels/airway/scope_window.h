#pragma once

#include <QWidget>

#include <memory>

namespace carina
{

class FlownEndoscope;
class LaryngoscopePanel;
class StationScene;

/// The picture of a laryngoscope over the whole of a screen, with the words beneath it, until Esc,
/// F11, a double click or its button closes it; it deletes itself then. An endoscope is flown on
/// from where it is.
class ScopeWindow : public QWidget
{
    Q_OBJECT

public:
    /// Opens on the screen of a panel that shows the same. @pre the station outlives it
    ScopeWindow(StationScene& station, std::shared_ptr<FlownEndoscope> endoscope,
                LaryngoscopePanel& opener);

    [[nodiscard]] const LaryngoscopePanel& panel() const { return *m_panel; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    LaryngoscopePanel* m_panel;
};

} // namespace carina
