#pragma once

#include "models/attention/attention_model.h"

#include <QMenu>
#include <QWidget>

class QLabel;
class QPushButton;
class QToolButton;

namespace carina
{

/// What needs attention most urgently, in a whole sentence, the button that settles it or shows
/// where it is, and one that dismisses it where that can be; a menu has the rest. Where nothing
/// needs attention the bar is hidden. It is as wide and as high as its sentence needs.
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

    /// The least that shows all of the sentence, in at most this width.
    [[nodiscard]] QSize sizeIn(int width) const;
    /// Lies there from now on, in its parent.
    void lie(const QRect& place);

private:
    void refresh();
    void listOther(const Attention& other);
    void listOthers();
    void showText();
    void announce(const QString& text);
    [[nodiscard]] Attention first() const;

    AttentionModel* m_model = nullptr;
    Attention m_shown;
    QPushButton* m_action;
    QPushButton* m_dismiss;
    QLabel* m_text;
    QToolButton* m_more;
    QMenu m_others;
};

} // namespace carina
