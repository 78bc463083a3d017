#pragma once

#include "models/network/strategy_model.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace carina
{

/// Asks a researcher by which strategy the session is to keep acted-on objects alike, and with
/// which parameters.
class StrategyDialog : public QDialog
{
    Q_OBJECT

public:
    explicit StrategyDialog(const StrategyChoice& choice, QWidget* parent = nullptr);

    [[nodiscard]] StrategyChoice choice() const;

private:
    void layOut();
    void fill(const StrategyChoice& choice);
    void refresh();

    QComboBox* m_strategy;
    QLabel* m_sentence;
    QSpinBox* m_delays;
    QDoubleSpinBox* m_start;
    QDoubleSpinBox* m_lowest;
    QDoubleSpinBox* m_highest;
    QSpinBox* m_lag;
};

} // namespace carina
