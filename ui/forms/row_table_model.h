// A list of plain rows as a table: one row per element, one column per leaf (vectors one per
// component). Cells are edited as text through the document; typed text that is no value stays in
// its cell.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/forms/form_context.h"

namespace rotorbench {

class RowTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  RowTableModel(const FormContext& context, QString listPath, QObject* parent);

  struct Column {
    QString key;  ///< path inside a row: "point.time"
    const schema::Field* field = nullptr;
    int component = -1;  ///< of a vector
  };
  [[nodiscard]] const Column& column(int index) const {
    return columns_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const QString& listPath() const { return list_; }
  /// Path of the problem and of the invalid text of a cell.
  [[nodiscard]] QString cellPath(int row, int column) const;
  /// The cell that shows `path`; invalid if there is none.
  [[nodiscard]] QModelIndex cellAt(const QString& path) const;
  [[nodiscard]] QString title(int column) const;

  /// Pastes cells at `row`, `column`, adding rows as needed. Nothing changes and the sentence says
  /// why if one cell does not fit; an empty sentence means success.
  QString paste(const QString& text, int row, int column);

  void reload();
  void refresh();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  void findColumns();
  /// `row`: the first one; no object if there is none.
  void addColumns(schema::ConstRef row, const QString& prefix);
  [[nodiscard]] QString leafPath(int row, const Column& column) const;
  [[nodiscard]] schema::Value cellValue(int row, const Column& column) const;
  [[nodiscard]] QString cellText(int row, const Column& column) const;
  [[nodiscard]] QString sentenceAt(const QString& cell) const;
  [[nodiscard]] bool isHeader(const QStringList& cells, int column) const;
  /// Writes one pasted cell into a copy of the document; the sentence says why it does not fit.
  QString pasteCell(schema::Ref scratch, const QString& text, int row, int column) const;
  QString pasteRows(schema::Ref scratch, const QList<QStringList>& rows, int row, int column,
                    qsizetype headers) const;

  const FormContext& context_;
  QString list_;
  std::vector<Column> columns_;
};

}  // namespace rotorbench
