#pragma once

#include <QWidget>

#include <memory>

class QAbstractItemModel;

namespace Ui
{
class ParticipantsPanel;
}

namespace carina
{

/// The participants of the session as a table.
class ParticipantsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParticipantsPanel(QWidget* parent = nullptr);
    ~ParticipantsPanel() override;

    /// @pre the model outlives the panel.
    void setModel(QAbstractItemModel& model);

private:
    std::unique_ptr<Ui::ParticipantsPanel> m_ui;
};

} // namespace carina
