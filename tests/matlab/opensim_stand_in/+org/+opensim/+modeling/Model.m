function model = Model()
% A new model of OpenSim has the credits of its authors.
    model.getCredits = @() 'Frank Anderson, Peter Loan';
end
