#pragma once

#include "models/lesson/lesson_model.h"

#include <QMenu>
#include <QToolButton>
#include <QWidget>

namespace carina
{

/// The switch by which an instructor shows their picture to others, with a mark while it is on, and
/// beside it to whom, and whether with the view.
class LessonBar : public QWidget
{
    Q_OBJECT

public:
    explicit LessonBar(QWidget* parent = nullptr);

    /// @pre the model outlives the bar.
    void setModel(LessonModel& model);
    /// Is reached by Tab before this.
    void putBefore(QWidget& after);

private:
    void refresh();
    void list();

    LessonModel* m_model = nullptr;
    QToolButton* m_switch;
    QToolButton* m_to;
    QMenu m_menu;
};

} // namespace carina
