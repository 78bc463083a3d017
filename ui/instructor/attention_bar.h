#pragma once

#include "models/attention/attention_model.h"

#include <QMenu>
#include <QWidget>

class QLabel;
class QPushButton;
class QToolButton;

namespace carina
{

/// One line with what needs attention most urgently, and the button that settles it or shows where
/// it is; a menu has the rest. Where nothing needs attention the line is hidden.
///
/// What is shown stays under a pointer or with the focus until it is settled, so that nobody
/// presses a button that has just changed its meaning. A screen reader hears each new matter.
class AttentionBar : public QWidget
{
    Q_OBJECT

public:
    explicit AttentionBar(QWidget* parent = nullptr);

    /// @pre the model outlives the bar.
    void setModel(AttentionModel& model);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void refresh();
    void listOthers();
    void showText();
    void announce(const QString& text);
    [[nodiscard]] Attention first() const;

    AttentionModel* m_model = nullptr;
    Attention m_shown;
    QPushButton* m_action;
    QLabel* m_text;
    QToolButton* m_more;
    QMenu m_others;
};

} // namespace carina
