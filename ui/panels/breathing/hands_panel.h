#pragma once

#include <QWidget>

#include <vector>

class QAction;
class QLabel;

namespace carina
{

class HandsModel;

/// What hands do at the patient that no sensor feels, as three actions with a key each: inflate or
/// deflate the cuff, draw the stylet, squeeze the bag or let it go. Each is a button here and can
/// be an entry of a menu. Where one is not for this person, the panel says why.
class HandsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit HandsPanel(QWidget* parent = nullptr);

    /// @pre the model outlives the panel.
    void setModel(HandsModel& model);

    /// Cuff, stylet, bag; they can be triggered once there is a model. Their keys act in the whole
    /// program, wherever the keyboard is, once a window has them.
    [[nodiscard]] std::vector<QAction*> handActions() const { return {m_cuff, m_stylet, m_bag}; }
    /// One sentence: what is not for this person, and why; empty where all is.
    [[nodiscard]] QString obstacle() const;

private:
    void layOut();
    void refresh();

    HandsModel* m_model = nullptr;
    QAction* m_cuff;
    QAction* m_stylet;
    QAction* m_bag;
    QLabel* m_obstacle;
    QLabel* m_travelling;
};

} // namespace carina
