#pragma once

#include "ui/scene/live_scope.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QLabel;

namespace carina
{

/// What the camera on a station's laryngoscope shows, in a picture of 4:3, and beneath it grade and
/// percentage of glottic opening, and what the blade does to tongue, epiglottis and teeth; or why
/// there is nothing to be seen, and what to do. The picture, which has a graphics engine of its
/// own, is made once the panel is in front of others.
class LaryngoscopePanel : public QWidget
{
    Q_OBJECT

public:
    explicit LaryngoscopePanel(QWidget* parent = nullptr);

    /// Shows the laryngoscope of this station from now on. To be called once.
    /// @pre it outlives the panel.
    void setStation(StationScene& station);

    /// What was read in the picture last (LiveScope::seen); nothing while there is none.
    [[nodiscard]] std::optional<GlotticView> seen() const
    {
        return m_scope ? m_scope->seen() : std::nullopt;
    }
    /// As it is written beneath the picture.
    [[nodiscard]] QString text() const;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void makePicture();
    void layOut();
    [[nodiscard]] int textHeight(int width) const;

    StationScene* m_station = nullptr;
    SceneView* m_picture = nullptr;
    QLabel* m_text;
    std::unique_ptr<LiveScope> m_scope;
    QTimer m_looking;
};

} // namespace carina
