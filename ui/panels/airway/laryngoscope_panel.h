#pragma once

#include "ui/scene/live_scope.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <memory>
#include <optional>

class QLabel;

namespace carina
{

class ScopeCanvas;
class ScopeControls;
class ScopeWindow;

/// Where a panel of the laryngoscope is.
enum class PanelPlace : std::uint8_t {
    Docked,     ///< beside others; its picture has a largest width
    WholeScreen ///< in a ScopeWindow, as large as it
};

/// What the camera on a station's laryngoscope shows, in a picture of 4:3, and beneath it grade and
/// percentage of glottic opening, and what the blade does to tongue, epiglottis and teeth; or why
/// there is nothing to be seen, and what to do. The picture, which has a graphics engine of its
/// own, is made once the panel is in front of others.
///
/// Or what an endoscope shows that a person flies by hand through the airway (FlownEndoscope), with
/// how deep it is: for the own eyes, with or without a laryngoscope, and without a grade.
///
/// A button, F11 while the keyboard is here, and a double click on the picture show all that over
/// the whole screen (ScopeWindow), and end it. The panel itself has no picture meanwhile.
class LaryngoscopePanel : public QWidget
{
    Q_OBJECT

public:
    explicit LaryngoscopePanel(QWidget* parent = nullptr)
        : LaryngoscopePanel{PanelPlace::Docked, std::make_shared<FlownEndoscope>(), parent}
    {
    }
    /// @param endoscope that another panel flies, too
    LaryngoscopePanel(PanelPlace place, std::shared_ptr<FlownEndoscope> endoscope,
                      QWidget* parent = nullptr);
    ~LaryngoscopePanel() override;

    /// Shows the laryngoscope of this station from now on. To be called once.
    /// @pre it outlives the panel.
    void setStation(StationScene& station);

    /// What was read in the picture last (LiveScope::seen); nothing while there is none.
    [[nodiscard]] std::optional<GlotticView> seen() const;
    /// As it is written beneath the picture.
    [[nodiscard]] QString text() const;

    /// What the blade does in the patient's mouth, while its picture is shown here; an estimate.
    [[nodiscard]] std::optional<BladeEffort> effort() const;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// Of one over the whole screen: it is to be closed.
    void wholeScreenToggled();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();
    void makePicture();
    void takeCamera();
    void layOut();
    void toggleWholeScreen();
    [[nodiscard]] bool isFlown() const;
    [[nodiscard]] QSize pictureIn(int width, int height) const;
    [[nodiscard]] int below(int width) const;
    [[nodiscard]] int textHeight(int width) const;

    PanelPlace m_place;
    std::shared_ptr<FlownEndoscope> m_endoscope;
    StationScene* m_station = nullptr;
    SceneView* m_picture = nullptr;
    ScopeCanvas* m_canvas;
    ScopeControls* m_controls;
    QLabel* m_text;
    QPointer<ScopeWindow> m_window; ///< while it is open
    std::unique_ptr<LiveScope> m_scope;
    QTimer m_looking;
};

} // namespace carina
