#pragma once

#include "models/network/network_figures.h"

#include <QAbstractTableModel>

namespace carina
{

/// The network figures of one participant as a table of two columns: quantity, and value with its
/// unit; first the delay and what it makes of shared objects, their drift. An unknown value is
/// shown as unknown.
class NetworkFiguresModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { What, HowMuch, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// std::nullopt empties the table.
    void show(const std::optional<NetworkFigures>& figures);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    struct Row {
        QString what;
        QString howMuch;
        QString meaning; ///< a sentence

        friend bool operator==(const Row&, const Row&) = default;
    };

    [[nodiscard]] static std::vector<Row> rowsOf(const NetworkFigures& figures);
    static void addDelay(const NetworkFigures& figures, std::vector<Row>& rows);
    static void addProbes(const NetworkFigures& figures, std::vector<Row>& rows);
    static void addTraffic(const TrafficReport& traffic, std::vector<Row>& rows);
    static void addActions(const NetworkFigures& figures, std::vector<Row>& rows);
    static void addClock(const NetworkFigures& figures, std::vector<Row>& rows);
    static void addObject(const ObjectFigures& object, std::vector<Row>& rows);

    /// A sentence, without its full stop: by what delays are measured.
    [[nodiscard]] static QString proberOf(const NetworkFigures& figures);
    /// The text of a row for a screen reader: without the state mark.
    [[nodiscard]] static QString spoken(const Row& row);

    std::vector<Row> m_rows;
};

} // namespace carina
